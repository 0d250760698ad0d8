package org.sami.spn.testing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Processes that tests start on their own Java and class path. Their temporary files lie in the test's folder and go with it: a process that is
 * killed deletes nothing, such as the library that SQLite unpacks.
 */
public final class JavaProcess {
    private JavaProcess() {}

    /**
     * How one is started.
     *
     * @param folder the test's
     * @param main the class that is run
     * @param arguments of its main method
     */
    public static ProcessBuilder builder(Path folder, Class<?> main, String... arguments) throws IOException {
        List<String> line = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                temporaryFilesIn(folder),
                "-cp",
                System.getProperty("java.class.path"),
                main.getName()));
        line.addAll(Arrays.asList(arguments));
        return new ProcessBuilder(line);
    }

    /** Java's option for temporary files in a folder {@code tmp} of the test's folder, which is made. */
    public static String temporaryFilesIn(Path folder) throws IOException {
        return "-Djava.io.tmpdir=" + Files.createDirectories(folder.resolve("tmp"));
    }
}
