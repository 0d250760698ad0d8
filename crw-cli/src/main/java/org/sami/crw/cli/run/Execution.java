package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.ZoneId;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.OutputOptions;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.ErrorMessages;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.cli.output.Version;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.report.RunOrigin;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.service.Geodesy;
import org.sami.crw.sim.resume.ConnectedJournal;
import org.sami.crw.sim.resume.EarlierProcesses;
import org.sami.crw.sim.resume.ResumedJournal;
import org.sami.crw.sim.resume.RunRecord;
import org.sami.crw.sim.resume.WrittenJournal;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.RunJournal;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.WallPacer;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.Parameters;
import org.sami.crw.sim.run.settings.PlanInterrupts;
import org.sami.crw.sim.run.settings.PlanLocations;
import org.sami.crw.sim.run.settings.PlannedMission;
import org.sami.crw.sim.run.settings.RunInput;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Site;
import org.sami.crw.sim.tcp.BoatsNotReadyException;
import org.sami.crw.sim.tcp.RunProcess;
import org.sami.crw.sim.tcp.TcpRun;
import org.sami.crw.sim.tcp.UnknownBoatException;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.json.VocabularyFiles;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine;

/** Runs a mission for a subcommand: with its journal, its progress and its report. */
final class Execution {
    private final PrintWriter out;
    private final PrintWriter err;
    private final DomainLibrary library;
    private final OutputOptions output;
    private final long connectWithinMillis;
    private final Clock clock;
    private Optional<Path> answersFile = Optional.empty();
    private Optional<Path> domainFolder = Optional.empty();
    private Optional<LostLinkAction> lostLink = Optional.empty();

    /** The run with its observer and the first messages. */
    @FunctionalInterface
    private interface Mission {
        RunReport run(RunObserver observer, Consumer<String> lines) throws IOException;
    }

    /** Of runs in this process alone. */
    Execution(CommandLine command, DomainLibrary library, OutputOptions output) {
        this(command, library, output, 0, Clock.system(ZoneId.systemDefault()));
    }

    /**
     * Of all runs.
     *
     * @param connectWithinMillis how long boats behind TCP may take to answer
     */
    Execution(CommandLine command, DomainLibrary library, OutputOptions output, long connectWithinMillis) {
        this(command, library, output, connectWithinMillis, Clock.system(ZoneId.systemDefault()));
    }

    /**
     * Of all runs.
     *
     * @param connectWithinMillis how long boats behind TCP may take to answer
     * @param clock says when a run begins, and in which time zone; nothing in the run reads it
     */
    Execution(CommandLine command, DomainLibrary library, OutputOptions output, long connectWithinMillis, Clock clock) {
        this.connectWithinMillis = connectWithinMillis;
        this.clock = clock;
        out = command.getOut();
        err = command.getErr();
        this.library = library;
        this.output = output;
    }

    /** Names the file of the answers of the run that begins: a later resume says when it differs. */
    Execution answersFrom(Optional<Path> file) {
        answersFile = file;
        return this;
    }

    /** Names the folder of the domain of the run that begins; empty for a domain that comes with the program. A later resume compares with it. */
    Execution domainFrom(Optional<Path> folder) {
        domainFolder = folder;
        return this;
    }

    /**
     * Runs a mission from its start.
     *
     * @param settings whose answers have no faults
     * @param journal its journal's file; null for none
     * @return the exit code
     */
    int runNew(PlanSource source, Plan plan, RunSettings settings, @Nullable JournalAddress journal)
            throws IOException {
        Project project = source.project().orElseThrow();
        RunPlan runPlan = new RunPlan(library.vocabulary(), project, plan);
        AnswersFile answers = answers(settings, library.vocabulary()).orThrow();
        checkSettings(runPlan, settings);
        output.prepare(err);
        RunRecord record = new RunRecord(
                settings,
                source.source(),
                new ProjectWriter(library.vocabulary()).text(project),
                library.files().texts(),
                Optional.of(new RunRecord.Start(clock.instant(), clock.getZone())),
                answersFile,
                domainFolder);
        checkJournal(journal);
        return settings.isConnected()
                ? runConnected(runPlan, record, answers, journal)
                : runInProcess(runPlan, record, answers, journal);
    }

    private static void checkJournal(@Nullable JournalAddress journal) throws IOException {
        if (journal == null) {
            return;
        }
        Optional<Path> file = journal.file();
        if (file.isPresent() ? Files.exists(file.get()) : journal.exists()) {
            throw new UsageFault("--journal: " + journal + " is there already; go on with it by 'crw resume " + journal
                    + "', or choose another");
        }
        if (file.isEmpty()) {
            return;
        }
        Path folder = file.get().toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new UsageFault("--journal: there is no folder " + folder);
        }
    }

    private int runInProcess(RunPlan plan, RunRecord record, AnswersFile answers, @Nullable JournalAddress journal)
            throws IOException {
        RunSettings settings = record.settings();
        if (journal == null) {
            return run(inProcess(plan, settings, answers, RunJournal.none()), record, journal);
        }
        try (WrittenJournal written = WrittenJournal.create(journal, record)) {
            tellJournal(journal);
            return run(inProcess(plan, settings, answers, written), record, journal);
        }
    }

    private int runConnected(RunPlan plan, RunRecord record, AnswersFile answers, @Nullable JournalAddress journal)
            throws IOException {
        RunSettings settings = record.settings();
        try (ConnectedJournal session =
                journal == null ? ConnectedJournal.none() : ConnectedJournal.create(journal, record)) {
            if (journal != null) {
                tellJournal(journal);
            }
            return run(connected(plan, settings, answers, session), record, journal);
        } catch (BoatsNotReadyException e) {
            throw journal == null ? e : new IOException(e.getMessage() + "; once they are: crw resume " + journal, e);
        }
    }

    private void tellJournal(JournalAddress journal) {
        tell("journal " + journal + "; if this process dies: crw resume " + journal);
    }

    /** What boats that are connected are to do when their link is lost; none is set where it is empty. */
    Execution lostLink(Optional<LostLinkAction> wish) {
        lostLink = wish;
        return this;
    }

    private Mission inProcess(RunPlan plan, RunSettings settings, AnswersFile answers, RunJournal journal) {
        InProcessRun run = new InProcessRun(plan, settings, answers, journal, output.pictures());
        run.useAllCores();
        return (observer, lines) -> run.run(WallPacer.of(settings.speed()), observer);
    }

    private Mission connected(RunPlan plan, RunSettings settings, AnswersFile answers, ConnectedJournal journal) {
        RunProcess start = RunProcess.ofThisProcess(connectWithinMillis);
        return (observer, lines) -> {
            try {
                return new TcpRun(plan, settings, answers, journal, start, lines)
                        .keepPicturesIn(output.pictures())
                        .setLostLink(lostLink)
                        .run(observer);
            } catch (UnknownBoatException e) {
                throw new UsageFault("--interrupt: " + e.getMessage());
            }
        };
    }

    /**
     * Looks whether values, places and interrupts fit the plan.
     *
     * @throws UsageFault if they do not
     */
    static void checkSettings(RunPlan plan, RunSettings settings) {
        try {
            Map<String, Value> parameters =
                    new Parameters(plan.vocabulary(), plan.project(), plan.plan()).read(settings.parameters());
            checkPlace(plan, settings, parameters.values());
            for (String more : settings.also()) {
                PlannedMission other = PlannedMission.parse(more, plan.vocabulary(), plan.project());
                checkPlace(
                        new RunPlan(plan.vocabulary(), plan.project(), other.plan()),
                        settings,
                        other.parameters().values());
            }
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--set: " + e.getMessage());
        }
        try {
            PlanInterrupts interrupts =
                    RunInput.of(plan, settings, AnswersFile.EMPTY).interrupts();
            if (settings.isConnected()) {
                interrupts.check(settings.interrupts()); // who the boats are is known when they have answered
            } else {
                interrupts.read(settings.interrupts(), settings.fleet().boatNames());
            }
        } catch (IllegalArgumentException e) {
            throw new UsageFault("--interrupt: " + e.getMessage());
        }
    }

    /** The run is not moved to the plan's place: the user requests that. */
    private static void checkPlace(RunPlan plan, RunSettings settings, Collection<Value> parameters) {
        GeoPoint centre = settings.fleet().site().centreInProcess();
        PlanLocations places = new PlanLocations(plan.project(), plan.plan(), parameters);
        Optional<GeoPoint> beyond = settings.isConnected() ? Optional.empty() : places.beyond(centre);
        if (beyond.isPresent()) {
            double km = Geodesy.distanceM(centre, beyond.get()) / 1000;
            throw new UsageFault(String.format(
                    Locale.ROOT,
                    "the plan names %s, %.0f km from the centre of the run, %s; to run it there: --at %s",
                    Site.words(beyond.get()),
                    km,
                    Site.words(centre),
                    Site.words(places.suitable(centre, settings.fleet().areaM()))));
        }
    }

    /** The answers of the simulated operator; findings where the text of the answers file has faults. */
    static Reading<AnswersFile> answers(RunSettings settings, Vocabulary vocabulary) {
        return settings.answers().isEmpty()
                ? new Reading<>(Optional.of(AnswersFile.EMPTY), List.of())
                : AnswersFileReader.read(settings.answers(), vocabulary);
    }

    /**
     * Goes on with a run.
     *
     * @param change what the user wants otherwise than recorded
     * @return the exit code
     */
    int resume(JournalAddress journal, UnaryOperator<RunSettings> change) throws IOException {
        if (!journal.exists()) {
            throw new UsageFault("there is no journal " + journal);
        }
        output.prepare(err);
        return isConnected(journal) ? resumeConnected(journal, change) : resumeInProcess(journal, change);
    }

    private static boolean isConnected(JournalAddress journal) throws IOException {
        try (JournalReader reader = journal.read()) {
            return RunRecord.of(reader.header()).settings().isConnected();
        }
    }

    private int resumeInProcess(JournalAddress journal, UnaryOperator<RunSettings> change) throws IOException {
        try (ResumedJournal resumed = ResumedJournal.open(journal)) {
            RunPlan plan = plan(resumed.record());
            RunSettings settings = change.apply(beyondItsLimit(resumed));
            tellDifferences(resumed, plan.vocabulary().domain());
            tell("going through " + resumed.resumedFrom().orElse(0) + " journal entries again, then going on");
            AnswersFile answers = answers(settings, plan.vocabulary()).orThrow();
            int code = run(
                    inProcess(plan, settings, answers, resumed),
                    resumed.record().with(settings),
                    journal);
            tellIfOver(code, resumed.added());
            return code;
        }
    }

    private int resumeConnected(JournalAddress journal, UnaryOperator<RunSettings> change) throws IOException {
        try (ConnectedJournal resumed = ConnectedJournal.open(journal)) {
            RunPlan plan = plan(resumed.record());
            RunSettings settings = change.apply(beyondItsLimit(resumed));
            tellDifferences(resumed, plan.vocabulary().domain());
            tell("going on after journal entry " + resumed.resumedFrom().orElse(0));
            AnswersFile answers = answers(settings, plan.vocabulary()).orThrow();
            int code = run(
                    connected(plan, settings, answers, resumed),
                    resumed.record().with(settings),
                    journal);
            tellIfOver(code, resumed.session().added());
            return code;
        }
    }

    private static RunPlan plan(RunRecord record) throws IOException {
        Vocabulary vocabulary =
                VocabularyReader.read(new VocabularyFiles(record.vocabulary())).orThrow();
        Project project = new ProjectReader(vocabulary).read(record.project()).orThrow();
        String id = record.settings().plan();
        return new RunPlan(
                vocabulary,
                project,
                project.plan(id).orElseThrow(() -> new IOException("the journal has no plan " + id)));
    }

    private void tellIfOver(int code, long added) {
        boolean over = code == ExitCode.OK || code == ExitCode.PROBLEMS || code == ExitCode.ABORTED;
        if (over && added == 0) {
            tell("this run was over already; nothing was added to its journal");
        }
    }

    /** A run that stopped at its {@code --for} is over with it: a resume continues it. */
    private static RunSettings beyondItsLimit(EarlierProcesses resumed) {
        RunSettings recorded = resumed.record().settings();
        boolean reached = recorded.limitMillis().isPresent()
                && resumed.cameToMillis() >= recorded.limitMillis().getAsLong();
        return reached ? recorded.withLimit(OptionalLong.empty()) : recorded;
    }

    private void tellDifferences(EarlierProcesses resumed, String domain) {
        if (!resumed.damage().isEmpty()) {
            tell("crw: " + resumed.damage());
        }
        RunRecord record = resumed.record();
        record.otherAnswers().ifPresent(this::tellDifference);
        Optional<DomainLibrary> present = DomainOption.present(domain, record.domainFolder());
        if (present.isEmpty() && record.domainFolder().isEmpty()) {
            return; // of a folder that its journal does not name: there is nothing to compare with
        }
        String project =
                present.map(words -> currentProject(record.source(), words)).orElse("");
        Map<String, String> files = present.map(words -> words.files().texts()).orElse(Map.of());
        resumed.differences(project, files).forEach(this::tellDifference);
    }

    private void tellDifference(String changed) {
        tell("crw: " + changed + " differs now from what this run began with; the run's own is used");
    }

    private void tell(String line) {
        err.println(line);
        err.flush();
    }

    private static String currentProject(String source, DomainLibrary words) {
        try {
            return PlanSource.find(source, words)
                    .project()
                    .map(new ProjectWriter(words.vocabulary())::text)
                    .orElse("");
        } catch (UsageFault gone) {
            return "";
        }
    }

    /** The reason for the exit code, in addition to the report, which may be for a program or be lost in a pipe. */
    private void tellFailure(RunReport report) {
        report.problems().forEach(problem -> err.println("crw: problem: " + problem.message()));
        if (report.result().outcome() == RunOutcome.FAILED) {
            err.println("crw: failed: " + report.result().reason());
            report.waits().forEach(wait -> wait.lines().forEach(line -> err.println("  " + line)));
            err.flush();
        }
    }

    private void tellSettings(RunSettings settings) {
        FleetSettings fleet = settings.fleet();
        err.printf(
                Locale.ROOT,
                "running %s: %ss %d%s, locations %d, area %.0f m, seed %d, speed %s%n",
                settings.plan(),
                fleet.robots().word(),
                fleet.boats(),
                fleet.copters() > 0 ? " (of them copters " + fleet.copters() + ")" : "",
                fleet.locations(),
                fleet.areaM(),
                fleet.seed(),
                settings.speed());
        if (settings.isConnected()) {
            err.println(fleet.robots().say("boats at ")
                    + settings.connect().stream().map(BoatAddress::toString).collect(Collectors.joining(", ")));
            tellSimulated(settings);
        } else {
            err.println("centre " + Site.words(fleet.site().centreInProcess())
                    + fleet.robots().say(", quay ")
                    + Site.words(fleet.site().quayInProcess(fleet.areaM())));
        }
        err.flush();
    }

    private void tellSimulated(RunSettings settings) {
        if (!settings.simulatedBesides().isEmpty()) {
            err.println("simulated here: " + String.join(", ", settings.simulatedBesides()) + "; quay "
                    + Site.words(settings.fleet()
                            .site()
                            .quayInProcess(settings.fleet().areaM())));
        }
    }

    private int run(Mission mission, RunRecord record, @Nullable JournalAddress journal) throws IOException {
        ProgressDisplay progress = new ProgressDisplay(err, Terminal.onStandardError(), System::nanoTime);
        RunReport report;
        boolean told;
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            tellSettings(record.settings()); // the reader may interrupt it
            Consumer<String> lines = line -> {
                progress.end();
                err.println(line);
                err.flush();
            };
            RunObserver.News news = new RunObserver.News(lines, ErrorMessages.wantsTrace());
            report = mission.run(new RunObserver(progress, stop, news), lines);
            progress.end();
            boolean stopped = Thread.interrupted(); // files could not be written otherwise
            report = record.start()
                    .map(start -> new RunOrigin(start.at(), start.zone(), Version.ofThisProgram()))
                    .map(report::withOrigin)
                    .orElse(report);
            told = output.tell(report, out, err);
            tellFailure(report);
            if (journal != null && report.result().outcome() == RunOutcome.RUNNING) {
                err.println((stopped ? "stopped; " : "") + "go on with: crw resume " + journal);
                err.flush();
            }
        }
        int code = ExitCode.of(report);
        return told || code != ExitCode.OK ? code : ExitCode.FAILED;
    }
}
