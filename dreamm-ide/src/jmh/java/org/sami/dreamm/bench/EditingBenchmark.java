package org.sami.dreamm.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.SynchronousQueue;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.issues.LiveFindings;
import org.sami.figures.Figure;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.model.Action;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.ui.net.WidePlan;

/**
 * A thousand edits in a plan of 500 vertices, with the live checks that follow each, in one process: how long the findings come after the edit,
 * and how much memory history and findings take. System property {@code quick} = true for a fifth of the edits.
 */
final class EditingBenchmark {
    static final String PREFIX = "editing.";
    private static final int PLACES = 250;

    private final int edits = Boolean.getBoolean("quick") ? 200 : 1000;
    private final List<Figure> figures = new ArrayList<>();

    /** Measures; throws where an edit was refused, or the live checks found something else than all checks. */
    List<Figure> run() throws InterruptedException {
        Plan plan = WidePlan.of(PLACES);
        Project project = new Project("wide", "Wide", "none", List.of(), List.of(), List.of(plan));
        ProjectDocument document = new ProjectDocument(WidePlan.NO_VOCABULARY, project, Optional.empty());
        ExecutorService worker = Executors.newSingleThreadExecutor();
        SynchronousQueue<Boolean> told = new SynchronousQueue<>();
        LiveFindings live = new LiveFindings(document, worker, work -> hand(work, told), System::nanoTime);
        told.take();
        double before = usedMiB();
        double[] ms = new double[edits];
        for (int i = 0; i < edits; i++) {
            EditResult result = document.apply(edit(plan, i));
            if (!(result instanceof EditResult.Done)) {
                throw new IllegalStateException("edit " + i + " was refused: " + result);
            }
            told.take();
            ms[i] = live.tookNs() / 1e6;
        }
        worker.shutdown();
        if (!live.findings().equals(PlanChecks.check(document.project(), WidePlan.NO_VOCABULARY))) {
            throw new IllegalStateException("live checks found something else than all checks");
        }
        double after = usedMiB();
        Arrays.sort(ms);
        figure("findings.median", ms[edits / 2], "ms");
        figure("findings.p99", ms[edits * 99 / 100], "ms");
        figure("memory.before", before, "MiB");
        figure("memory.after", after, "MiB");
        figure("memory.edit", (after - before) * 1024 / edits, "KiB/edit");
        return figures;
    }

    /** The owner's thread is the worker's here: the benchmark's thread waits meanwhile. */
    private static void hand(Runnable work, SynchronousQueue<Boolean> told) {
        work.run();
        try {
            told.put(true);
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        }
    }

    /** Names, moves and requirements in turn, all over the plan. */
    private static Edit edit(Plan plan, int i) {
        int at = i * 7 % PLACES;
        return switch (i % 3) {
            case 0 -> new VertexEdit.NameVertex(plan.id(), "p" + at, "Name " + i);
            case 1 -> new VertexEdit.MoveVertices(plan.id(), Map.of("t" + at, new LayoutPoint(i, i)));
            default ->
                new EdgeEdit.SetOutRequirements(
                        plan.id(), "out" + at, List.of(OutRequirement.of(Action.TAKE, 2 + i, TokenKind.ANY_PROXY)));
        };
    }

    private static double usedMiB() {
        Runtime runtime = Runtime.getRuntime();
        for (int i = 0; i < 3; i++) {
            System.gc();
        }
        return (runtime.totalMemory() - runtime.freeMemory()) / 1048576.0;
    }

    private void figure(String name, double value, String unit) {
        figures.add(new Figure(PREFIX + name, Map.of("vertices", 2 * PLACES, "edits", edits), value, unit, 0));
    }
}
