package org.sami.dreamm.bench;

import java.awt.GraphicsEnvironment;
import java.nio.file.Path;
import java.util.List;
import org.sami.dreamm.Dreamm;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;
import org.sami.ui.check.StartBenchmark;

/**
 * Runs the benchmarks of DREAMM, prints tables and puts them into the file of all benchmarks. System properties: {@code benchmarks.file}; {@code
 * installed.script}, the start script of the program; {@code quick} = true for less than a minute; {@code window.install} says how to get a display.
 */
public final class DreammBenchmarkMain {
    private static final String START = "dreamm.start";

    private DreammBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws Exception {
        write(EditingBenchmark.PREFIX, new EditingBenchmark().run());
        if (GraphicsEnvironment.isHeadless()) {
            System.out.println("The start of DREAMM is not measured, for there is no display; get one by: "
                    + System.getProperty("window.install"));
            return;
        }
        Path script = Path.of(System.getProperty("installed.script"));
        write(
                START,
                new StartBenchmark(START, script, Dreamm.class, "dreamm-window")
                        .measure(Boolean.getBoolean("quick") ? 3 : 10));
    }

    private static void write(String prefix, List<Figure> figures) throws Exception {
        FigureFile.print(figures);
        FigureFile.replace(FigureFile.ofThisBuild(), prefix, figures);
    }
}
