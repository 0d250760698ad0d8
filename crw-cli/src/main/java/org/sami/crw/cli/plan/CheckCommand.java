package org.sami.crw.cli.plan;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.legacy.ImportedFindings;
import org.sami.crw.cli.option.DepthOption;
import org.sami.crw.cli.option.DomainOption;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.option.SecondsConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.sim.run.settings.PlanInterrupts;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Severity;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.statespace.DeepRequest;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw check}: what is wrong with a plan, a file, or a domain and its library. */
@Command(
        name = "check",
        mixinStandardHelpOptions = true,
        description = "Reads a project file and checks its plans; prints what it finds, with the place in the file, "
                + "and the interrupts that the plans offer.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:no errors; there may be warnings",
            "1:there are errors: the plan would not be started; with --deep also where a search has found something",
            "2:wrong usage, or there is no such file"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw check my-plan.json",
            "  crw check clv --json",
            "  crw check my-plan.json --explain          with why each finding matters and how to mend it",
            "  crw check my-plan.json --deep             runs its plans with invented boats",
            "  crw check my-plan.json --suggest e7       requirements for the edge e7 that leave fewer findings",
            "  crw check --domain uav search             a plan of the aircraft domain that ships with crw",
            "  crw check --domain my-domain              the domain and its library",
            "  crw check --domain my-domain plan.json    a plan in that domain's vocabulary"
        })
public final class CheckCommand implements Callable<Integer> {
    private static final int MOST_BOATS = 25;
    private static final int MOST_STATES = 1_000_000;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            paramLabel = "FILE|PLAN",
            arity = "0..1",
            description =
                    "A project's file or folder, or a plan of the library by its id. May be left out with --domain.")
    private @Nullable String name;

    @Mixin
    private DomainOption domain = new DomainOption();

    @Option(names = "--json", description = "Print one JSON object.")
    private boolean json;

    @Option(
            names = "--explain",
            description = "Below each finding, why it matters and how to mend it. With --json it is always there.")
    private boolean explain;

    @Option(
            names = "--deep",
            description = "Search every possible run of each plan without errors, as DREAMM does by Search "
                    + "deeper; print each finding with a run that shows it.")
    private boolean deep;

    @Option(
            names = "--boats",
            paramLabel = "N",
            defaultValue = "2",
            description = "With --deep: how many boats there are at the start. Default: ${DEFAULT-VALUE}.")
    private int boats;

    @Mixin
    private DepthOption depth = new DepthOption();

    @Option(
            names = "--states",
            paramLabel = "N",
            defaultValue = "" + DeepRequest.STANDARD_STATES,
            description = "With --deep: how many states of each plan are looked at. Default: ${DEFAULT-VALUE}.")
    private int states;

    @Option(
            names = "--budget",
            paramLabel = "SECONDS",
            defaultValue = "60",
            converter = SecondsConverter.class,
            description = "With --deep: how long the search of each plan on the engine may take, and each search for "
                    + "the answer to a saved query. Default: ${DEFAULT-VALUE}.")
    private long budgetMillis;

    @Option(
            names = "--suggest",
            paramLabel = "EDGE",
            description = "Suggest requirements for the edge with this id: try those that the language allows on 1, 2 "
                    + "and 3 boats, and print which leave fewer findings, with what each changes.")
    private @Nullable String edge;

    @Override
    public Integer call() {
        if (budgetMillis == 0) {
            throw new UsageFault("--budget is more than 0");
        }
        if (name == null && !domain.isGiven()) {
            throw new UsageFault(
                    "nothing to check: name FILE|PLAN, a file or a plan of the library, or --domain NAME|FOLDER");
        }
        if (boats < 0 || boats > MOST_BOATS || states < 1 || states > MOST_STATES) {
            throw new UsageFault("--boats is from 0 to " + MOST_BOATS + " and --states from 1 to " + MOST_STATES
                    + ", not " + boats + " and " + states);
        }
        if (deep && name == null) {
            throw new UsageFault("--deep runs the plans of a FILE or a PLAN: name one");
        }
        if (edge != null && name == null) {
            throw new UsageFault("--suggest changes an edge of a FILE or a PLAN: name one");
        }
        Reading<DomainLibrary> read = domain.read();
        if (read.result().isEmpty()) {
            return tell(domain.name(), read.findings());
        }
        DomainLibrary library = read.result().get();
        if (name == null) {
            List<Finding> findings = new ArrayList<>(read.findings());
            domain.all(library).forEach(source -> findings.addAll(source.findings()));
            return tell(domain.name(), findings);
        }
        return tell(name, library, domain.find(name, library));
    }

    private int tell(String source, List<Finding> findings) {
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(FindingsText.json(source, findings).toPrettyString());
        } else {
            print(out, source, findings);
        }
        out.flush();
        return findings.stream().anyMatch(Finding::isError) ? ExitCode.FINDINGS : ExitCode.OK;
    }

    private PlanSearches searched(DomainLibrary library, PlanSource source) {
        PlanSearches searches = new PlanSearches(depth.levels());
        if (deep) { // plans with errors are left out
            ProgressDisplay progress =
                    new ProgressDisplay(spec.commandLine().getErr(), Terminal.onStandardError(), System::nanoTime);
            try (StopOnInterrupt stop = new StopOnInterrupt()) {
                source.project()
                        .ifPresent(project -> searches.run(
                                project,
                                library.vocabulary(),
                                boats,
                                states,
                                Duration.ofMillis(budgetMillis),
                                progress,
                                stop));
            }
        }
        return searches;
    }

    private Optional<RequirementSuggestions> suggested(DomainLibrary library, PlanSource source) {
        String wanted = edge;
        if (wanted == null) {
            return Optional.empty();
        }
        ProgressDisplay progress =
                new ProgressDisplay(spec.commandLine().getErr(), Terminal.onStandardError(), System::nanoTime);
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            return source.project()
                    .map(project -> RequirementSuggestions.find(project, library.vocabulary(), wanted, progress, stop));
        }
    }

    private int tell(String checked, DomainLibrary library, PlanSource source) {
        PrintWriter out = spec.commandLine().getOut();
        PlanSearches searches = searched(library, source);
        Optional<RequirementSuggestions> suggestions = suggested(library, source);
        if (json) {
            ObjectNode object = FindingsText.json(checked, source.findings());
            imported(source).ifPresent(imported -> {
                ObjectNode origin = object.putObject("imported")
                        .put("from", imported.origin().file());
                origin.put("ofImport", imported.ofImport().size());
                origin.put("ofPlans", imported.ofPlans().size());
            });
            ObjectNode interrupts = object.putObject("interrupts");
            source.project()
                    .ifPresent(project -> project.plans().forEach(plan -> {
                        ArrayNode names = interrupts.putArray(plan.id());
                        new PlanInterrupts(library.vocabulary(), project, plan)
                                .names()
                                .forEach(names::add);
                    }));
            if (deep) {
                searches.put(object, checked);
            }
            suggestions.ifPresent(found -> found.put(object));
            out.println(object.toPrettyString());
        } else {
            searches.print(out, checked, explain);
            suggestions.ifPresent(found -> found.print(out));
            Optional<ImportedFindings> imported = imported(source);
            if (imported.isPresent()) {
                print(out, checked, imported.get());
                count(out, checked, source.findings());
            } else {
                print(out, checked, source.findings());
            }
            source.project()
                    .ifPresent(project -> project.plans().forEach(plan -> {
                        PlanInterrupts interrupts = new PlanInterrupts(library.vocabulary(), project, plan);
                        if (!interrupts.names().isEmpty()) {
                            out.printf("%s: --interrupt %s%n", plan.id(), interrupts.inWords());
                        }
                    }));
        }
        out.flush();
        return source.hasErrors() || searches.haveFound() ? ExitCode.FINDINGS : ExitCode.OK;
    }

    private void print(PrintWriter out, String source, List<Finding> findings) {
        printFindings(out, source, findings);
        count(out, source, findings);
    }

    private void printFindings(PrintWriter out, String source, List<Finding> findings) {
        if (explain) {
            FindingsText.printExplained(out, source, findings);
        } else {
            FindingsText.print(out, source, findings);
        }
    }

    private static void count(PrintWriter out, String source, List<Finding> findings) {
        out.printf(
                "%s: %d errors, %d warnings%n",
                source, FindingsText.count(findings, Severity.ERROR), FindingsText.count(findings, Severity.WARNING));
    }

    private static Optional<ImportedFindings> imported(PlanSource source) {
        return source.project()
                .flatMap(p -> p.importedFrom().map(origin -> ImportedFindings.of(p, origin, source.findings())));
    }

    /** What the import did, what it may have caused, and what the plans' own authors drew so. */
    private void print(PrintWriter out, String name, ImportedFindings imported) {
        out.printf("%s: %s%n", name, imported.heading());
        if (!imported.ofImport().isEmpty()) {
            out.println("at elements that the import wrote otherwise than they stood there:");
            printFindings(out, name, imported.ofImport());
        }
        if (!imported.ofPlans().isEmpty()) {
            out.println("of the plans as they were drawn:");
            printFindings(out, name, imported.ofPlans());
        }
    }
}
