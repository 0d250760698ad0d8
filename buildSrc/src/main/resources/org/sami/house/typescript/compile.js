/*
 * Checks the files of a folder and makes modules of them, with TypeScript's compiler, which is loaded as `ts`. All files are in memory:
 * `sources` and `libraries` give a text by name or null, `names` are the sources, `say` takes a fault, `write` a module.
 */
(function (names, sources, libraries, say, write) {
  const place = (diagnostic) => {
    if (!diagnostic.file) {
      return '';
    }
    const {line, character} = ts.getLineAndCharacterOfPosition(diagnostic.file, diagnostic.start);
    return nameOf(diagnostic.file.fileName) + '(' + (line + 1) + ',' + (character + 1) + '): ';
  };
  const nameOf = (path) => path.replace(/^\/(sources|libraries)\//, '');
  const textOf = (path) => (path.startsWith('/sources/') ? sources(nameOf(path)) : path.startsWith('/libraries/') ? libraries(nameOf(path)) : null) ?? undefined;
  const fault = (diagnostic) => say(place(diagnostic) + ts.flattenDiagnosticMessageText(diagnostic.messageText, '\n    '));

  const config = ts.parseConfigFileTextToJson('tsconfig.json', sources('tsconfig.json') ?? '{}');
  const {options, errors} = ts.convertCompilerOptionsFromJson(config.config?.compilerOptions ?? {}, '/sources', 'tsconfig.json');
  const wrong = [...(config.error ? [config.error] : []), ...errors];
  if (wrong.length > 0) {
    wrong.forEach(fault);
    return;
  }
  const host = {
    getSourceFile: (path, version) => {
      const text = textOf(path); // whose comments mean nothing to the compiler: to leave them alone is a quarter of the time
      return text === undefined ? undefined : ts.createSourceFile(path, text, {...version, jsDocParsingMode: ts.JSDocParsingMode.ParseNone});
    },
    getDefaultLibLocation: () => '/libraries',
    getDefaultLibFileName: () => '/libraries/lib.d.ts',
    getCurrentDirectory: () => '/sources',
    getCanonicalFileName: (path) => path,
    useCaseSensitiveFileNames: () => true,
    getNewLine: () => '\n',
    fileExists: (path) => textOf(path) !== undefined,
    readFile: textOf,
    writeFile: () => {},
  };
  const program = ts.createProgram(names.map((name) => '/sources/' + name), {...options, rootDir: '/sources', outDir: '/out'}, host);
  const faults = ts.sortAndDeduplicateDiagnostics([
    ...program.getOptionsDiagnostics(), ...program.getSyntacticDiagnostics(), ...program.getGlobalDiagnostics(), ...program.getSemanticDiagnostics()]);
  if (faults.length > 0) {
    faults.forEach(fault);
    return;
  }
  program.emit(undefined, (path, text) => {
    if (!/^\s*export \{\};\s*$/.test(text.replace(/^\s*(\/\/.*|\/\*[^]*?\*\/)\s*$/gm, ''))) { // else it has types alone
      write(path.slice('/out/'.length), text);
    }
  });
})
