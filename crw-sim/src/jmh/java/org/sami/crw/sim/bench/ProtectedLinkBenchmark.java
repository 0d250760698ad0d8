package org.sami.crw.sim.bench;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.sami.boat.link.security.KeyRing;
import org.sami.crw.sim.bench.FleetBenchmark.Measured;
import org.sami.figures.Figure;

/** Protected links next to plain ones, in turn within one run, so that other work on the machine meets both. */
final class ProtectedLinkBenchmark {
    private static final String NAME = "link.tls";
    private static final int BOATS = 250;
    private static final int CONNECTED = 20;

    private final double warmUpS;
    private final double measuredS;
    private final int rounds;

    ProtectedLinkBenchmark(double warmUpS, double measuredS, int rounds) {
        this.warmUpS = warmUpS;
        this.measuredS = measuredS;
        this.rounds = rounds;
    }

    /** Medians over the rounds; as error, how far apart the rounds were. */
    List<Figure> run() throws Exception {
        List<Measured> plain = new ArrayList<>();
        List<Measured> tls = new ArrayList<>();
        List<Double> linkedS = new ArrayList<>();
        System.out.printf(
                Locale.ROOT,
                "%n%6s %12s %13s %10s %8s %9s %12s%n",
                "links",
                "base, cores",
                "boats, cores",
                "median ms",
                "p99 ms",
                "poses/s",
                "20 boats, s");
        for (int round = 0; round < rounds; round++) {
            plain.add(row("plain", new FleetBenchmark(BOATS, warmUpS, measuredS).measure(Optional.empty()), 0));
            double seconds = linkTwenty();
            linkedS.add(seconds);
            tls.add(row(
                    "TLS",
                    new FleetBenchmark(BOATS, warmUpS, measuredS).measure(Optional.of(KeyRing.inMemory())),
                    seconds));
        }
        List<Figure> figures = new ArrayList<>();
        figures.addAll(figures(plain, 0));
        figures.addAll(figures(tls, 1));
        Map<String, Integer> params = Map.of("boats", BOATS);
        figures.add(ratio(params, plain, tls, Measured::baseMicrosAPose, "CPU of the base a pose, TLS : plain"));
        figures.add(ratio(params, plain, tls, Measured::boatsMicrosAPose, "CPU of the boats a pose, TLS : plain"));
        figures.add(new Figure(
                NAME, Map.of("boats", CONNECTED), middle(linkedS), "s until all are linked, TLS", apart(linkedS)));
        return figures;
    }

    private static double linkTwenty() throws Exception {
        return new FleetBenchmark(CONNECTED, 0, 1)
                .measure(Optional.of(KeyRing.inMemory()))
                .linkedAfterS();
    }

    private static Measured row(String links, Measured measured, double linkedS) {
        System.out.printf(
                Locale.ROOT,
                "%6s %12.3f %13.3f %10.2f %8.2f %9.0f %12s%n",
                links,
                measured.baseCores(),
                measured.boatsCores(),
                measured.medianMs(),
                measured.p99Ms(),
                measured.posesPerS(),
                linkedS == 0 ? "" : String.format(Locale.ROOT, "%.2f", linkedS));
        return measured;
    }

    private static List<Figure> figures(List<Measured> rounds, int tls) {
        Map<String, Integer> params = Map.of("boats", BOATS, "tls", tls);
        return List.of(
                figure(params, rounds, Measured::baseCores, "of one core, CPU of the base"),
                figure(params, rounds, Measured::boatsCores, "of one core, CPU of the boats"),
                figure(params, rounds, Measured::medianMs, "ms, acknowledgement, median"),
                figure(params, rounds, Measured::p99Ms, "ms, acknowledgement, p99"));
    }

    private static Figure figure(
            Map<String, Integer> params, List<Measured> rounds, ToDoubleFunction<Measured> what, String unit) {
        List<Double> values = rounds.stream().map(what::applyAsDouble).toList();
        return new Figure(NAME, params, middle(values), unit, apart(values));
    }

    private static Figure ratio(
            Map<String, Integer> params,
            List<Measured> plain,
            List<Measured> tls,
            ToDoubleFunction<Measured> what,
            String unit) {
        List<Double> ratios = new ArrayList<>();
        for (int i = 0; i < plain.size(); i++) {
            ratios.add(what.applyAsDouble(tls.get(i)) / what.applyAsDouble(plain.get(i)));
        }
        return new Figure(NAME, params, middle(ratios), unit, apart(ratios));
    }

    private static double middle(List<Double> values) {
        List<Double> sorted = new ArrayList<>(values);
        Collections.sort(sorted);
        return sorted.get(sorted.size() / 2);
    }

    private static double apart(List<Double> values) {
        return (Collections.max(values) - Collections.min(values)) / 2;
    }
}
