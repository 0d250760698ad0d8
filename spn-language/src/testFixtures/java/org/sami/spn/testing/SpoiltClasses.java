package org.sami.spn.testing;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** Classes with one line of one source changed, compiled into a folder and loaded next to the right ones. The code has no hooks for this. */
public final class SpoiltClasses extends ClassLoader {
    private static final JavaCompiler COMPILER = ToolProvider.getSystemJavaCompiler();

    /** For all compilations: it has read the directories of the class path's jars once. */
    private static final StandardJavaFileManager FILES = COMPILER.getStandardFileManager(null, null, null);

    private final Path classes;
    private final Predicate<String> own;

    private SpoiltClasses(Path classes, Predicate<String> own) {
        super(SpoiltClasses.class.getClassLoader());
        this.classes = classes;
        this.own = own;
    }

    /**
     * Compiles a source with a change.
     *
     * @param right what stands in the source exactly once
     * @param wrong what is to stand there instead
     * @param own names of the classes that come from here; all others come from the tests' own class loader
     */
    public static SpoiltClasses with(Path folder, Path source, String right, String wrong, Predicate<String> own) {
        try {
            String text = Files.readString(source);
            int at = text.indexOf(right);
            if (at < 0 || text.indexOf(right, at + 1) >= 0) {
                throw new IllegalStateException("Not exactly once in " + source.getFileName() + ": " + right);
            }
            compile(Files.writeString(folder.resolve(source.getFileName()), text.replace(right, wrong)), folder);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return new SpoiltClasses(folder, own);
    }

    /** One compilation at a time, as they share the file manager. */
    private static synchronized void compile(Path source, Path into) {
        List<String> options =
                List.of("-proc:none", "-nowarn", "-cp", System.getProperty("java.class.path"), "-d", into.toString());
        boolean compiled = COMPILER.getTask(null, FILES, null, options, null, FILES.getJavaFileObjects(source))
                .call();
        if (!compiled) {
            throw new IllegalStateException("The spoilt " + source.getFileName() + " does not compile");
        }
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        if (!own.test(name)) {
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
