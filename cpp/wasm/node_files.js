// SPDX-License-Identifier: GPL-3.0-or-later
// Corrections of Emscripten's NODERAWFS where its files differ from the machine's, and calls from the program to
// web/cli.
mergeInto(LibraryManager.library, {
  $NodeFiles__deps: ['$FS', '$NODERAWFS', '$SYSCALLS', '$ERRNO_CODES'],
  $NodeFiles__postset: 'NodeFiles.install();',
  $NodeFiles: {
    install: function () {
      var [open, close, read, write, rename, unlink] = [FS.open, FS.close, FS.read, FS.write, FS.rename, FS.unlink];
      FS.open = function (path, flags, mode, descriptor) {
        // Records a new file, which is removed if the program is interrupted.
        var isNew = (flags & 128) !== 0;
        if (isNew) Module['madeFile'](path);
        try {
          var stream = open(path, flags, mode, descriptor);
        } catch (error) {
          if (isNew) Module['madeFile'](undefined);
          throw error;
        }
        // Only regular files have a write position.
        stream.seekable = fs.fstatSync(stream.nfd).isFile();
        return stream;
      };
      FS.close = function (stream) {
        if (stream.isDuplicate) FS.closeStream(stream.fd);
        else close(stream);
      };
      FS.read = NodeFiles.waiting(read);
      FS.write = NodeFiles.waiting(write);
      FS.rename = function (from, to) {
        rename(from, to);
        Module['madeFile'](undefined);
      };
      FS.unlink = function (path) {
        unlink(path);
        Module['madeFile'](undefined);
      };
      // Paths go to Node unchanged, because a path through a symbolic link cannot be shortened.
      SYSCALLS.calculateAt = function (folder, path) {
        return path;
      };
    },

    /** Another program may have set a terminal or a pipe so that it does not wait. */
    waiting: function (operation) {
      return function (...args) {
        for (;;) {
          try {
            return operation(...args);
          } catch (error) {
            if (error.errno !== ERRNO_CODES['EAGAIN']) throw error;
            Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 5);
          }
        }
      };
    },

    /** The result of a system call: the value of `operation`, or the number of its error. */
    result: function (operation) {
      try {
        return operation();
      } catch (error) {
        if (error instanceof FS.ErrnoError) return -error.errno;
        if (error.code in ERRNO_CODES) return -ERRNO_CODES[error.code];
        throw error;
      }
    },

    /** The stream of a descriptor, also of one that the program was started with. */
    streamOf: function (fd) {
      if (!FS.getStream(fd)) {
        fs.fstatSync(fd);
        FS.streams[fd] = { fd: fd, nfd: fd, position: 0, path: '', flags: 2, seekable: false };
      }
      return FS.getStream(fd);
    },
  },

  __syscall_dup__deps: ['$NodeFiles'],
  __syscall_dup: function (fd) {
    return NodeFiles.result(function () {
      // Node has no dup: the copy writes to the same descriptor, which stays open.
      var copy = Object.assign({}, NodeFiles.streamOf(fd), { isDuplicate: true });
      copy.fd = FS.nextfd(3);
      FS.streams[copy.fd] = copy;
      return copy.fd;
    });
  },
  __syscall_fstat64__deps: ['$NodeFiles'],
  __syscall_fstat64: function (fd, buffer) {
    return NodeFiles.result(function () {
      var status = fs.fstatSync(SYSCALLS.getStreamFromFD(fd).nfd);
      return SYSCALLS.doStat(function () { return status; }, '', buffer);
    });
  },
  __syscall_fchmod__deps: ['$NodeFiles'],
  __syscall_fchmod: function (fd, mode) {
    return NodeFiles.result(function () {
      fs.fchmodSync(SYSCALLS.getStreamFromFD(fd).nfd, mode);
      return 0;
    });
  },
  __syscall_fchown32__deps: ['$NodeFiles'],
  __syscall_fchown32: function (fd, owner, group) {
    return NodeFiles.result(function () {
      fs.fchownSync(SYSCALLS.getStreamFromFD(fd).nfd, owner, group);
      return 0;
    });
  },
  __syscall_faccessat__deps: ['$NodeFiles'],
  __syscall_faccessat: function (folder, path, mode) {
    return NodeFiles.result(function () {
      fs.accessSync(SYSCALLS.getStr(path), mode);
      return 0;
    });
  },

  // Called by node_program.cpp.
  circle_voronoi_umask: function () {
    return process.umask();
  },
  circle_voronoi_show_line: function (when) {
    return Module['showLine'](UTF8ToString(when)) ? 1 : 0;
  },
  circle_voronoi_show_stage: function (stage, size, done) {
    Module['showStage'](UTF8ToString(stage, size), done);
  },
  circle_voronoi_end_line: function () {
    Module['endLine']();
  },
});
