package org.sami.crw.sim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.function.UnaryOperator;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.resume.ResumedJournal;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.resume.WrittenJournal;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.Pacer;
import org.sami.crw.sim.run.Parameters;
import org.sami.crw.sim.run.PlanInterrupts;
import org.sami.crw.sim.run.RunJournal;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.RunPlan;
import org.sami.crw.sim.run.RunSettings;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.json.VocabularyFiles;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine;

/** Runs a mission for a subcommand: with its journal, its progress and its report. */
final class Execution {
    private final PrintWriter out;
    private final PrintWriter err;
    private final DomainLibrary library;
    private final OutputOptions output;

    Execution(CommandLine command, DomainLibrary library, OutputOptions output) {
        out = command.getOut();
        err = command.getErr();
        this.library = library;
        this.output = output;
    }

    /**
     * Runs a mission from its start.
     *
     * @param journal its journal's file; null for none
     * @return the exit code
     */
    int runNew(PlanSource source, Plan plan, RunSettings settings, Path journal) throws IOException {
        Project project = source.project().orElseThrow();
        RunPlan runPlan = new RunPlan(library.vocabulary(), project, plan);
        Reading<AnswersFile> answers = answers(settings, library.vocabulary());
        if (answers.hasErrors()) {
            FindingsText.print(err, "--answers", answers.findings());
            err.flush();
            return ExitCode.FINDINGS;
        }
        checkSettings(runPlan, settings);
        output.prepare();
        if (journal == null) {
            return run(new InProcessRun(runPlan, settings, answers.orThrow(), RunJournal.none()), settings, journal);
        }
        if (Files.exists(journal)) {
            throw new UsageFault("--journal: " + journal + " is there already; go on with it by 'crw resume " + journal
                    + "', or choose another file");
        }
        Path folder = journal.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new UsageFault("--journal: there is no folder " + folder);
        }
        RunRecord record = new RunRecord(
                settings,
                source.source(),
                new ProjectWriter(library.vocabulary()).text(project),
                library.files().texts());
        try (WrittenJournal written = WrittenJournal.create(journal, record)) {
            err.println("journal " + journal + "; if this process dies: crw resume " + journal);
            err.flush();
            return run(new InProcessRun(runPlan, settings, answers.orThrow(), written), settings, journal);
        }
    }

    private static void checkSettings(RunPlan plan, RunSettings settings) {
        try {
            new Parameters(plan.vocabulary(), plan.project(), plan.plan()).read(settings.parameters());
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--set: " + e.getMessage());
        }
        try {
            new PlanInterrupts(plan.vocabulary(), plan.project(), plan.plan())
                    .read(settings.interrupts(), settings.fleet().boatNames());
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--interrupt: " + e.getMessage());
        }
    }

    private static Reading<AnswersFile> answers(RunSettings settings, Vocabulary vocabulary) {
        return settings.answers().isEmpty()
                ? new Reading<>(java.util.Optional.of(AnswersFile.EMPTY), List.of())
                : AnswersFileReader.read(settings.answers(), vocabulary);
    }

    /**
     * Goes on with a run.
     *
     * @param change what the user wants otherwise than recorded
     * @return the exit code
     */
    int resume(Path journal, UnaryOperator<RunSettings> change) throws IOException {
        if (!Files.isRegularFile(journal)) {
            throw new UsageFault("there is no journal " + journal);
        }
        output.prepare();
        try (ResumedJournal resumed = ResumedJournal.open(journal)) {
            RunRecord record = resumed.record();
            Vocabulary vocabulary = VocabularyReader.read(new VocabularyFiles(record.vocabulary()))
                    .orThrow();
            Project project =
                    new ProjectReader(vocabulary).read(record.project()).orThrow();
            RunSettings settings = change.apply(beyondItsLimit(record.settings(), resumed));
            Plan plan = project.plan(settings.plan())
                    .orElseThrow(() -> new IOException("the journal has no plan " + settings.plan()));
            tellDifferences(resumed, record);
            InProcessRun run = new InProcessRun(
                    new RunPlan(vocabulary, project, plan),
                    settings,
                    answers(settings, vocabulary).orThrow(),
                    resumed);
            int code = run(run, settings, journal);
            boolean over = code == RunOutcome.ENDED.exitCode() || code == RunOutcome.ABORTED.exitCode();
            if (over && resumed.added() == 0) {
                err.println("this run was over already; nothing was added to its journal");
                err.flush();
            }
            return code;
        }
    }

    /** A run that stopped at its {@code --for} is over with it: whoever takes it up wants more of it. */
    private RunSettings beyondItsLimit(RunSettings recorded, ResumedJournal resumed) {
        boolean reached = recorded.limitMillis().isPresent()
                && resumed.cameToMillis() >= recorded.limitMillis().getAsLong();
        return reached ? recorded.withLimit(OptionalLong.empty()) : recorded;
    }

    private void tellDifferences(ResumedJournal resumed, RunRecord record) {
        if (!resumed.damage().isEmpty()) {
            err.println("crw: " + resumed.damage());
        }
        for (String changed :
                resumed.differences(currentProject(record), library.files().texts())) {
            err.println("crw: " + changed + " differs now from what this run began with; the run's own is used");
        }
        err.println("going through " + resumed.resumedFrom().orElse(0) + " journal entries again, then going on");
        err.flush();
    }

    private String currentProject(RunRecord record) {
        try {
            return PlanSource.find(record.source(), library)
                    .project()
                    .map(new ProjectWriter(library.vocabulary())::text)
                    .orElse("");
        } catch (UsageFault gone) {
            return "";
        }
    }

    private int run(InProcessRun run, RunSettings settings, Path journal) throws IOException {
        RunSettings.Fleet fleet = settings.fleet();
        err.printf(
                Locale.ROOT,
                "running %s: boats %d, locations %d, area %.0f m, seed %d, speed %s%n",
                settings.plan(),
                fleet.boats(),
                fleet.locations(),
                fleet.areaM(),
                fleet.seed(),
                settings.speed());
        err.flush();
        ProgressDisplay progress = new ProgressDisplay(err, Terminal.onStandardError(), System::nanoTime);
        RunReport report;
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            report = run.run(Pacer.of(settings.speed()), new RunObserver(progress, stop));
            progress.end();
            boolean stopped = Thread.interrupted(); // files could not be written otherwise
            output.tell(report, out, err);
            if (journal != null && report.result().outcome() == RunOutcome.RUNNING) {
                err.println((stopped ? "stopped; " : "") + "go on with: crw resume " + journal);
                err.flush();
            }
        }
        return report.result().outcome().exitCode();
    }
}
