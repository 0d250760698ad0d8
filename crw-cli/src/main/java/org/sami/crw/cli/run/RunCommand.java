package org.sami.crw.cli.run;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.JournalConverter;
import org.sami.crw.cli.option.LinkOptions;
import org.sami.crw.cli.option.OutputOptions;
import org.sami.crw.cli.option.PlanOption;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.option.RunOptions;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.finding.Finding;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw run}: one mission on simulated boats. */
@Command(
        name = "run",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description =
                "Runs a plan on simulated boats with a simulated operator, and reports the result. Progress goes to "
                        + "standard error, the report to standard output.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the mission ended",
            "1:the plan or the answers file has errors; nothing was run",
            "2:wrong usage, or a file that cannot be read",
            "3:the mission was aborted",
            "4:the mission or the program failed, or boats do not answer or are all of another kind (--connect), or none is near"
                    + " (--near)",
            "5:the mission was still running when the run was stopped (--for, Ctrl-C)",
            "6:the mission ended, with problems that are named"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw run clv",
            "  crw run clv --boats 5 --locations 30 --speed max --report out",
            "  crw run --domain uav search --boats 5 --speed max",
            "  crw run clv --connect 127.0.0.1:5001,127.0.0.1:5002 --area 60 --locations 6",
            "  crw run clv --near                     on the boats of the local network that are paired",
            "  crw run my-project.json --plan search --also watch@60",
            "  crw run my-project.json --script day.script",
            "  crw run station-keep --set watch-time.duration=60s --speed max",
            "  crw run my-project.json --plan search --journal search.journal --json"
        })
public final class RunCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private LinkOptions links = new LinkOptions();

    @Parameters(
            paramLabel = "PLAN|FILE",
            arity = "0..1",
            description = "A plan of the library by its id (see 'crw plans'), or a project's file or folder.")
    private @Nullable String name;

    /** Warns of what a mission does although it was disabled for trying (docs/file-format.md). */
    private static final String DISABLED = "W-DISABLED";

    @Mixin
    private PlanOption planOption = new PlanOption();

    @Mixin
    private DomainOption domain = new DomainOption();

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private RunOptions options;

    @Option(
            names = "--journal",
            paramLabel = "FILE",
            converter = JournalConverter.class,
            description = "Write a journal, so that 'crw resume FILE' can go on if this process dies; a file, or"
                    + " postgresql://HOST:PORT/DATABASE.")
    private @Nullable JournalAddress journal;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private OutputOptions output;

    @Override
    public Integer call() throws Exception {
        links.use();
        PrintWriter err = spec.commandLine().getErr();
        Optional<DomainLibrary> words = domain.library(err);
        if (words.isEmpty()) {
            return ExitCode.FINDINGS;
        }
        DomainLibrary library = words.get();
        PlanSource source = options.source(name, library);
        if (source.project().isEmpty()) {
            FindingsText.print(err, source.source(), source.findings());
            err.flush();
            return ExitCode.FINDINGS;
        }
        List<Plan> plans = options.plans(source, planOption.name(), library.vocabulary());
        Plan plan = plans.get(0);
        List<Finding> concerning = source.concerning(plans);
        if (concerning.stream().anyMatch(Finding::isError)) {
            FindingsText.print(err, source.source(), concerning);
            err.flush();
            return ExitCode.FINDINGS;
        }
        FindingsText.print(
                err,
                source.source(),
                concerning.stream().filter(f -> f.code().equals(DISABLED)).toList());
        err.flush();
        List<BoatAddress> found = List.of();
        if (options.nearOn().isPresent()) {
            options.checkConnected();
            found = BoatSearch.connectable(options.nearOn().get(), err);
            if (found.isEmpty()) {
                return ExitCode.FAILED;
            }
        }
        RunSettings given = options.settings(plan.id(), plan.title(), found);
        RunSettings settings = options.withRobots(given, HandlerModules.robotsOf(library.vocabulary()));
        options.checkScript(new RunPlan(library.vocabulary(), source.project().get(), plan), settings);
        Reading<AnswersFile> answers = Execution.answers(settings, library.vocabulary());
        if (answers.hasErrors()) {
            FindingsText.print(err, options.answersFile(), answers.findings());
            err.flush();
            return ExitCode.FINDINGS;
        }
        return new Execution(spec.commandLine(), library, output, options.connectWithinMillis())
                .answersFrom(options.answersPath())
                .domainFrom(domain.folder())
                .lostLink(options.lostLink())
                .runNew(source, plan, settings, journal);
    }
}
