package org.sami.crw.mavlink.bench;

import java.nio.file.Path;
import java.util.List;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;

/**
 * Runs the benchmark of a base with vehicles that speak MAVLink, prints its table and puts it into the file of all benchmarks. System properties:
 * {@code benchmarks.file}; {@code quick} = true for less than two minutes.
 */
public final class VehicleBenchmarkMain {
    private VehicleBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws Exception {
        boolean quick = Boolean.getBoolean("quick");
        Path file = FigureFile.ofThisBuild();
        List<Figure> figures = new VehicleBenchmark(25, quick ? 20 : 60, quick ? 20 : 60).run();
        FigureFile.print(figures);
        FigureFile.replace(file, VehicleBenchmark.NAME, figures);
        System.out.println("Written to " + file);
    }
}
