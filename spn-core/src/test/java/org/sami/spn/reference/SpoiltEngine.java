package org.sami.spn.reference;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.sami.spn.model.Project;
import org.sami.spn.testing.TestVocabulary;

/**
 * The engine with one line of its source changed, compiled into a folder and loaded next to the right one. The engine has no
 * hooks for this.
 */
final class SpoiltEngine extends ClassLoader {
    private static final Path SOURCES = Path.of("src/main/java/org/sami/spn/engine/rule");
    private static final String ENGINE = "org.sami.spn.engine.";
    private static final JavaCompiler COMPILER = ToolProvider.getSystemJavaCompiler();

    /** For all compilations, one after another: it has read the directories of the class path's jars once. */
    private static final StandardJavaFileManager FILES = COMPILER.getStandardFileManager(null, null, null);

    private final Path classes;

    private SpoiltEngine(Path classes) {
        super(SpoiltEngine.class.getClassLoader());
        this.classes = classes;
    }

    /**
     * Compiles the engine with a change.
     *
     * @param file the source file, from the folder of the rules, such as {@code Firing.java}
     * @param right what stands there exactly once
     * @param wrong what is to stand there instead
     */
    static Differential.Maker with(Path folder, String file, String right, String wrong) {
        try {
            Path unchanged = SOURCES.resolve(file);
            String source = Files.readString(unchanged);
            int at = source.indexOf(right);
            if (at < 0 || source.indexOf(right, at + 1) >= 0) {
                throw new IllegalStateException("Not exactly once in " + file + ": " + right);
            }
            Path changed = Files.writeString(folder.resolve(unchanged.getFileName()), source.replace(right, wrong));
            compile(changed, folder);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        SpoiltEngine loader = new SpoiltEngine(folder);
        return loader::subject;
    }

    private static void compile(Path source, Path into) {
        List<String> options =
                List.of("-proc:none", "-nowarn", "-cp", System.getProperty("java.class.path"), "-d", into.toString());
        boolean compiled = COMPILER.getTask(null, FILES, null, options, null, FILES.getJavaFileObjects(source))
                .call();
        if (!compiled) {
            throw new IllegalStateException("The spoilt " + source.getFileName() + " does not compile");
        }
    }

    private Subject subject(Project project) {
        try {
            return (Subject) loadClass(EngineSubject.class.getName())
                    .getConstructors()[0]
                    .newInstance(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
        } catch (InvocationTargetException e) {
            throw new IllegalStateException(e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The engine and what speaks to it come from here, everything else from the tests' own class loader. */
    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        if (!name.startsWith(ENGINE) && !name.equals(EngineSubject.class.getName())) {
            return super.loadClass(name, resolve);
        }
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            return loaded != null ? loaded : define(name);
        }
    }

    private Class<?> define(String name) throws ClassNotFoundException {
        String file = name.replace('.', '/') + ".class";
        Path changed = classes.resolve(file);
        try (InputStream in = Files.exists(changed)
                ? Files.newInputStream(changed)
                : getParent().getResourceAsStream(file)) {
            if (in == null) {
                throw new ClassNotFoundException(name);
            }
            byte[] bytes = in.readAllBytes();
            return defineClass(name, bytes, 0, bytes.length);
        } catch (IOException e) {
            throw new ClassNotFoundException(name, e);
        }
    }
}
