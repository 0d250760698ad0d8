package org.sami.house.typescript;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.graalvm.polyglot.Context;
import org.graalvm.polyglot.Source;
import org.graalvm.polyglot.proxy.ProxyArray;
import org.graalvm.polyglot.proxy.ProxyExecutable;

/**
 * TypeScript's compiler on a JavaScript engine for the JVM, in a process of its own whose class path has both: no Node is needed. The engine gets
 * texts by name and gives texts by name, it reads and writes no file.
 */
public final class TypeScriptCompiler {
    private static final String COMPILER = "META-INF/resources/webjars/typescript/";

    private final String script;
    private final Map<String, String> libraries;

    private TypeScriptCompiler(String script, Map<String, String> libraries) {
        this.script = script;
        this.libraries = libraries;
    }

    /**
     * Checks and compiles all files of a folder. Faults go to standard error, a line {@code FILE(LINE,COLUMN): MESSAGE} each.
     *
     * @param args the folder of the sources and the one that the modules are put into; with a fault in the sources, nothing is put there and the exit code is 1
     * @throws IOException where a file cannot be read or written, or no compiler is on the class path
     */
    public static void main(String[] args) throws IOException {
        List<String> faults = onClassPath().compile(Path.of(args[0]), Path.of(args[1]));
        PrintStream out = new PrintStream(System.err, true, StandardCharsets.UTF_8);
        faults.forEach(out::println);
        System.exit(faults.isEmpty() ? 0 : 1);
    }

    /**
     * The compiler in a jar of the class path.
     *
     * @throws IOException where there is none
     */
    static TypeScriptCompiler onClassPath() throws IOException {
        for (String jar : System.getProperty("java.class.path").split(File.pathSeparator)) {
            if (jar.endsWith(".jar")) {
                try (ZipFile zip = new ZipFile(jar)) {
                    Map<String, String> files = new TreeMap<>();
                    for (ZipEntry entry : Collections.list(zip.entries())) {
                        String name = entry.getName().substring(entry.getName().lastIndexOf('/') + 1);
                        if (entry.getName().startsWith(COMPILER)
                                && (name.equals("typescript.js") || name.matches("lib\\..*d\\.ts"))) {
                            try (InputStream in = zip.getInputStream(entry)) {
                                files.put(name, new String(in.readAllBytes(), StandardCharsets.UTF_8));
                            }
                        }
                    }
                    if (files.containsKey("typescript.js")) {
                        return new TypeScriptCompiler(files.get("typescript.js"), files);
                    }
                }
            }
        }
        throw new IOException("no jar of the class path has " + COMPILER);
    }

    /**
     * Checks and compiles all files of a folder, with the options of its {@code tsconfig.json}.
     *
     * @return what is wrong with them; empty where all of them were compiled
     * @throws IOException where a file cannot be read or written
     */
    List<String> compile(Path from, Path into) throws IOException {
        Map<String, String> sources = new TreeMap<>();
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : (Iterable<Path>) files.filter(Files::isRegularFile)::iterator) {
                sources.put(from.relativize(file).toString().replace(File.separatorChar, '/'), Files.readString(file));
            }
        }
        List<String> faults = new ArrayList<>();
        Map<String, String> modules = new TreeMap<>();
        run(sources, faults::add, modules);
        if (faults.isEmpty()) {
            for (Map.Entry<String, String> module : modules.entrySet()) {
                Path file = into.resolve(module.getKey());
                Files.createDirectories(file.getParent());
                Files.writeString(file, module.getValue());
            }
        }
        return faults;
    }

    private void run(Map<String, String> sources, Consumer<String> faults, Map<String, String> modules)
            throws IOException {
        Object[] names =
                sources.keySet().stream().filter(name -> name.endsWith(".ts")).toArray();
        ProxyExecutable fault = args -> {
            faults.accept(args[0].asString());
            return null;
        };
        ProxyExecutable write = args -> modules.put(args[0].asString(), args[1].asString());
        try (Context engine = Context.newBuilder("js")
                        .option("engine.WarnInterpreterOnly", "false")
                        .build();
                InputStream in = TypeScriptCompiler.class.getResourceAsStream("compile.js")) {
            engine.eval(Source.newBuilder("js", script, "typescript.js").build());
            Source driver = Source.newBuilder("js", new String(in.readAllBytes(), StandardCharsets.UTF_8), "compile.js")
                    .build();
            engine.eval(driver).execute(ProxyArray.fromArray(names), texts(sources), texts(libraries), fault, write);
        }
    }

    private static ProxyExecutable texts(Map<String, String> byName) {
        return args -> byName.get(args[0].asString());
    }
}
