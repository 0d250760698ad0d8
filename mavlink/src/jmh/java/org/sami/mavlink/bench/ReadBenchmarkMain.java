package org.sami.mavlink.bench;

import java.nio.file.Path;
import java.util.List;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;

/**
 * Runs the benchmark of reading, prints its table and puts it into the file of all benchmarks. System properties: {@code benchmarks.file}; {@code quick} = true
 * for less than two minutes.
 */
public final class ReadBenchmarkMain {
    private ReadBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws Exception {
        boolean quick = Boolean.getBoolean("quick");
        Path file = FigureFile.ofThisBuild();
        List<Figure> figures = new ReadBenchmark(quick ? 1 : 4, quick ? 3 : 9).run();
        FigureFile.print(figures);
        FigureFile.replace(file, ReadBenchmark.NAME, figures);
        System.out.println("Written to " + file);
    }
}
