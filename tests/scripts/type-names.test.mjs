// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { typesOf } from '../../scripts/type-names.mjs'

it('finds the types of named namespaces, with their qualified names', () => {
  const text = `namespace circle_voronoi {
struct Declared;
struct Rings {
  struct Inner {
  };
};
namespace {
class Local {
};
}  // namespace
namespace exact {
class Sign final : public Base {
};
}  // namespace exact
enum class Kind { one, two };
}  // namespace circle_voronoi
`
  expect(typesOf(text)).toEqual(['circle_voronoi::Rings', 'circle_voronoi::exact::Sign', 'circle_voronoi::Kind'])
})
