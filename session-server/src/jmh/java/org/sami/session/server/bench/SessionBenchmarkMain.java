package org.sami.session.server.bench;

import java.nio.file.Path;
import java.util.List;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;

/**
 * Runs the benchmark of a served session, prints its table and puts it into the file of all benchmarks. System properties: {@code benchmarks.file};
 * {@code quick} = true for less than two minutes.
 */
public final class SessionBenchmarkMain {
    private SessionBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws Exception {
        boolean quick = Boolean.getBoolean("quick");
        Path file = FigureFile.ofThisBuild();
        List<Figure> figures = new FrontsBenchmark(250, 10, quick ? 10 : 30, quick ? 10 : 60).run();
        FigureFile.print(figures);
        FigureFile.replace(file, "session.", figures);
        System.out.println("Written to " + file);
        System.exit(0); // HTTP clients and servers leave threads
    }
}
