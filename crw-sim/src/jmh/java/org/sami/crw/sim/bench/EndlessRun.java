package org.sami.crw.sim.bench;

import java.io.IOException;
import java.nio.file.Path;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.resume.WrittenJournal;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;

/** A run, with its journal, of a fleet that keeps its stations for hours, as fast as it goes; the operator never ends it. */
public final class EndlessRun implements AutoCloseable {
    /** Milliseconds of an hour. */
    public static final double HOUR_MS = 3_600_000;

    private static final String PLAN = "station-keep";
    private static final String NEVER_END =
            "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [{\"event\": \"OperatorApprove\", \"answer\": {\"yes\": false}}]}";
    private static final double MEBIBYTE = 1 << 20;

    private final WrittenJournal journal;
    private final InProcessRun run;

    /**
     * Opens it.
     *
     * @param file of its journal
     */
    public EndlessRun(int boats, int hours, Path file) throws IOException {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Project project = library.projectOf(PLAN).orElseThrow();
        RunPlan plan =
                new RunPlan(library.vocabulary(), project, project.plan(PLAN).orElseThrow());
        RunSettings settings = RunSettings.of(PLAN, PLAN, new FleetSettings(boats, 1, 600, 1))
                .limitMillis((long) (hours * HOUR_MS))
                .answers(NEVER_END)
                .build();
        RunRecord record = new RunRecord(
                settings,
                PLAN,
                new ProjectWriter(library.vocabulary()).text(project),
                library.files().texts());
        journal = WrittenJournal.create(file, record);
        run = new InProcessRun(
                plan,
                settings,
                AnswersFileReader.read(NEVER_END, library.vocabulary()).orThrow(),
                journal);
    }

    /** The run, which nobody has begun. */
    public InProcessRun run() {
        return run;
    }

    /** MiB of the heap that are in use after a collection. */
    public static double liveHeapMiB() {
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        return (runtime.totalMemory() - runtime.freeMemory()) / MEBIBYTE;
    }

    @Override
    public void close() throws IOException {
        journal.close();
    }
}
