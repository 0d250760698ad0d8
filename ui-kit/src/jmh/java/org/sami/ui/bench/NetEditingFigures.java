package org.sami.ui.bench;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.sami.palette.ProxyMarks;
import org.sami.picture.NetFonts;
import org.sami.picture.net.NetMode;
import org.sami.spn.drawing.MovedDrawing;
import org.sami.spn.drawing.NetDetail;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.net.NetView;
import org.sami.ui.net.WidePlan;

/**
 * How long it takes while a net is edited: a frame while a vertex of 500 is dragged, the drawing after an edit, and opening and laying out the
 * largest project of the field, where that lies next to the project.
 */
final class NetEditingFigures {
    private static final Path LEGACY = Path.of("../shared/legacy-plans/crw.json");
    private static final String CRW = "/org/sami/domain/crw";

    private final int times;
    private final int width;
    private final int height;
    private final Figure figure;

    /** Takes a figure: its name, parameters, median and 95th percentile in ms. */
    interface Figure {
        void take(String name, SortedMap<String, Integer> params, double median, double p95);
    }

    NetEditingFigures(int times, int width, int height, Figure figure) {
        this.times = times;
        this.width = width;
        this.height = height;
        this.figure = figure;
    }

    void run() {
        Plan plan = WidePlan.of(250);
        NetDrawing drawing = edited(plan, WidePlan.NO_VOCABULARY);
        NetView net = new NetView(new ProxyMarks());
        net.setMode(NetMode.ALL);
        net.setSize(width, height);
        net.doLayout();
        net.show(plan, WidePlan.NO_VOCABULARY, drawing);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Set<String> dragged = Set.of(plan.places().get(120).id());
        SortedMap<String, Integer> vertices = new TreeMap<>(Map.of("vertices", 500));
        int[] step = {0};
        measure("net.drag", vertices, times, () -> {
            net.preview(MovedDrawing.of(drawing, dragged, Set.of(), Set.of(), step[0]++ % 200, 10));
            Graphics2D g = image.createGraphics();
            net.paint(g);
            g.dispose();
        });
        measure("net.edited", vertices, Math.max(20, times / 10), () -> edited(plan, WidePlan.NO_VOCABULARY));
        if (Files.exists(LEGACY)) {
            legacy();
        } else {
            System.out.println("no figures of the field's plans: there is no " + LEGACY);
        }
    }

    private void legacy() {
        Vocabulary vocabulary = VocabularyReader.fromClassPath(CRW).orThrow();
        Project project = read(vocabulary);
        SortedMap<String, Integer> plans =
                new TreeMap<>(Map.of("plans", project.plans().size()));
        measure("legacy.open", plans, 10, () -> read(vocabulary).plans().forEach(plan -> edited(plan, vocabulary)));
        Plan largest = project.plans().stream()
                .max(Comparator.comparingInt(NetEditingFigures::size))
                .orElseThrow();
        measure(
                "legacy.layers",
                new TreeMap<>(Map.of("vertices", size(largest))),
                10,
                () -> NetLayout.layered(largest, vocabulary, NetFonts::width));
    }

    private static int size(Plan plan) {
        return plan.places().size() + plan.transitions().size();
    }

    private static Project read(Vocabulary vocabulary) {
        return new LegacyImport(
                        vocabulary,
                        LegacyTableReader.fromClassPath(CRW + "/legacy.json", vocabulary)
                                .orThrow())
                .read(LEGACY)
                .project()
                .orElseThrow();
    }

    private static NetDrawing edited(Plan plan, Vocabulary vocabulary) {
        return NetLayout.edited(plan, vocabulary, NetFonts::width, NetDetail.AUTHOR, OptionalDouble.empty());
    }

    private void measure(String name, SortedMap<String, Integer> params, int count, Runnable work) {
        double[] ms = new double[count];
        for (int i = -count / 3; i < count; i++) { // the first ones warm up
            long before = System.nanoTime();
            work.run();
            if (i >= 0) {
                ms[i] = (System.nanoTime() - before) / 1e6;
            }
        }
        Arrays.sort(ms);
        figure.take(name, params, ms[count / 2], ms[count * 95 / 100]);
    }
}
