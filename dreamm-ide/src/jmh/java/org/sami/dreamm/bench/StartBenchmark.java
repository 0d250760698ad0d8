package org.sami.dreamm.bench;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.event.PaintEvent;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.dreamm.Dreamm;
import org.sami.ui.EventThread;

/** How long DREAMM takes from the start of its process until its window with the library of plans is painted first. */
public final class StartBenchmark {
    private static final String NAME = "dreamm.start";
    private static final String WINDOW = "dreamm-window";
    private static final ObjectMapper JSON = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);

    private StartBenchmark() {}

    /**
     * Measures.
     *
     * @param args how many times; or the arguments of DREAMM in a process that is measured, which says how many ms it took and ends
     */
    public static void main(String[] args) throws Exception {
        if (GraphicsEnvironment.isHeadless()) {
            System.out.println("The start of DREAMM is not measured, for there is no display; get one by: "
                    + System.getProperty("window.install"));
            return;
        }
        if (args.length == 1) {
            measure(Integer.parseInt(args[0]));
            return;
        }
        AtomicBoolean seen = new AtomicBoolean();
        Toolkit.getDefaultToolkit()
                .addAWTEventListener(
                        event -> {
                            if (event instanceof PaintEvent
                                    && event.getSource() instanceof Component component
                                    && WINDOW.equals(component.getName())
                                    && seen.compareAndSet(false, true)) {
                                EventThread.later(StartBenchmark::painted);
                            }
                        },
                        AWTEvent.PAINT_EVENT_MASK);
        Dreamm.main(args);
    }

    private static void painted() {
        System.out.println(System.currentTimeMillis()
                - ManagementFactory.getRuntimeMXBean().getStartTime());
        Runtime.getRuntime().halt(0);
    }

    private static void measure(int times) throws Exception {
        List<Double> seconds = new ArrayList<>();
        for (int i = -1; i < times; i++) { // the first one fills the caches of the machine
            double took = once();
            if (i >= 0) {
                seconds.add(took);
            }
        }
        Collections.sort(seconds);
        double median = seconds.get(seconds.size() / 2);
        double most = seconds.get(seconds.size() - 1);
        System.out.printf(
                Locale.ROOT, "%s: %.2f s from process to first paint, median; most %.2f s%n", NAME, median, most);
        write(Path.of(System.getProperty("benchmarks.file", "build/benchmarks.json")), median, most - median);
    }

    /** One process of the program, with the flags of its start script and the archive of classes where there is one. */
    private static double once() throws Exception {
        Path data = Files.createTempDirectory("dreamm-start");
        List<String> line = new ArrayList<>(
                List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        line.addAll(Arrays.asList("-XX:+UseSerialGC", "-Xshare:auto", "-XX:TieredStopAtLevel=1", "-XX:-UsePerfData"));
        Path lib = Path.of(System.getProperty("dreamm.lib"));
        line.add("-XX:SharedArchiveFile=" + lib.resolve("dreamm.jsa"));
        String program = Files.readString(lib.resolveSibling("bin").resolve("dreamm"))
                .lines()
                .filter(each -> each.startsWith("classpath="))
                .findFirst()
                .orElseThrow()
                .substring("classpath=".length())
                .replace("$lib", lib.toString());
        line.addAll(List.of("-cp", program + ":" + System.getProperty("java.class.path")));
        line.addAll(List.of(StartBenchmark.class.getName(), "--data", data.toString()));
        Process process = new ProcessBuilder(line)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        String said = process.inputReader(StandardCharsets.UTF_8).readLine();
        process.waitFor();
        if (said == null) {
            throw new IllegalStateException("the window was not painted");
        }
        return Long.parseLong(said) / 1000.0;
    }

    private static void write(Path file, double median, double error) throws IOException {
        ArrayNode all = JSON.createArrayNode();
        if (Files.exists(file)) {
            for (JsonNode entry : JSON.readTree(file.toFile())) {
                if (!entry.path("name").asText().equals(NAME)) {
                    all.add(entry);
                }
            }
        }
        ObjectNode entry = all.addObject().put("name", NAME);
        entry.putObject("params").put("plans", 30);
        entry.put("value", median)
                .put("unit", "s, process to first paint, median")
                .put("error", error);
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.writeString(file, JSON.writeValueAsString(all) + "\n");
    }
}
