package org.sami.ui.check;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.figures.Figure;
import org.sami.spn.testing.TemporaryFolder;

/** How long an installed program takes from the start of its process until its window is painted first. */
public final class StartBenchmark {
    private static final Pattern CLASS_PATH = Pattern.compile("(?m)^classpath=(.*)$");
    private static final Pattern FLAGS = Pattern.compile("(?m)^flags='(.*)'$");

    private final String name;
    private final Path script;
    private final Class<?> program;
    private final String window;

    /**
     * Of a program that takes {@code --data DIR}.
     *
     * @param name of the figure
     * @param script that starts the installed program: its classes, archive and flags are used
     * @param window name of its frame
     */
    public StartBenchmark(String name, Path script, Class<?> program, String window) {
        this.name = name;
        this.script = script;
        this.program = program;
        this.window = window;
    }

    /** The median of so many starts, each with a new data directory, after one that fills the machine's caches. */
    public List<Figure> measure(int times) throws IOException, InterruptedException {
        List<Double> seconds = new ArrayList<>();
        once();
        for (int i = 0; i < times; i++) {
            seconds.add(once());
        }
        Collections.sort(seconds);
        double median = seconds.get(times / 2);
        double most = seconds.get(times - 1);
        return List.of(
                new Figure(name, Map.of("starts", times), median, "s, process to first paint, median", most - median));
    }

    private double once() throws IOException, InterruptedException {
        try (TemporaryFolder data = new TemporaryFolder("start")) {
            Process process = new ProcessBuilder(line(data.path()))
                    .redirectError(ProcessBuilder.Redirect.INHERIT)
                    .start();
            String said = process.inputReader(StandardCharsets.UTF_8).readLine();
            process.waitFor();
            if (said == null) {
                throw new IOException(script + " ended before its window was painted");
            }
            return Long.parseLong(said) / 1000.0;
        }
    }

    private List<String> line(Path data) throws IOException {
        String text = Files.readString(script);
        Path lib = script.resolveSibling("../lib").normalize();
        List<String> line = new ArrayList<>();
        line.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        line.addAll(List.of(value(FLAGS, text).split(" ")));
        line.add("-XX:SharedArchiveFile=" + lib.resolve(script.getFileName() + ".jsa"));
        String own = value(CLASS_PATH, text).replace("$lib", lib.toString());
        line.addAll(List.of("-cp", own + File.pathSeparator + System.getProperty("java.class.path")));
        line.addAll(List.of(FirstPaint.class.getName(), window, program.getName(), "--data", data.toString()));
        return line;
    }

    private String value(Pattern line, String text) {
        Matcher found = line.matcher(text);
        if (!found.find()) {
            throw new IllegalStateException(script + " has no line " + line);
        }
        return found.group(1);
    }
}
