// SPDX-License-Identifier: GPL-3.0-or-later
export function renderMarkdown(markdown: string): { readonly title: string; readonly html: string }
