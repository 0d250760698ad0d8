package org.sami.crw.cli.plan;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.sami.crw.cli.option.PlanOption;
import org.sami.crw.cli.option.PlansArgument;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.model.Plan;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseChart;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw phases}: the phase chart of a plan (thesis 5.2.3). */
@Command(
        name = "phases",
        mixinStandardHelpOptions = true,
        description = {
            "Shows the phase chart of a plan: its events with the markups Phase Item and Phase Branch, phase by phase.",
            "Each actor has a row; time goes to the right. Actions below one another can run at the same time."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:it was shown", "1:the file has errors", "2:wrong usage, or there is no such file or phase"},
        footerHeading = "%nExamples:%n",
        footer = {"  crw phases my-project.json --plan search", "  crw phases my-project.json --choose \"Another one\""
        })
public final class PhasesCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PlansArgument plans = new PlansArgument();

    @Mixin
    private PlanOption planOption = new PlanOption();

    @Option(
            names = "--choose",
            paramLabel = "OPTION",
            description = "Show the effects of this branch, named by its label. Repeatable; default: the first branch"
                    + " everywhere.")
    private List<String> choices = new ArrayList<>();

    @Override
    public Integer call() {
        Optional<PlansArgument.Read> read = plans.read(spec.commandLine().getErr());
        if (read.isEmpty()) {
            return ExitCode.FINDINGS;
        }
        Plan plan = read.get().source().choose(planOption.name());
        PhaseChart chart = PhaseChart.of(plan, read.get().library().vocabulary());
        PrintWriter out = spec.commandLine().getOut();
        Map<String, String> chosen = chosen(chart);
        out.print(
                chart.isEmpty()
                        ? plan.title() + " has no phases: none of its events has the markup Phase Item\n"
                        : new PhaseText(chart, chosen).text());
        out.flush();
        return ExitCode.OK;
    }

    private Map<String, String> chosen(PhaseChart chart) {
        Map<String, String> chosen = new LinkedHashMap<>();
        for (String choice : choices) {
            boolean found = false;
            for (PhaseAction action : chart.actions()) {
                for (PhaseAction option : chart.options(action.id())) {
                    if (option.label().equals(choice)) {
                        chosen.put(action.id(), option.id());
                        found = true;
                    }
                }
            }
            if (!found) {
                throw new UsageFault("--choose: no branch is called '" + choice + "'" + offered(chart));
            }
        }
        return chosen;
    }

    private static String offered(PhaseChart chart) {
        String labels = chart.actions().stream()
                .filter(PhaseAction::branch)
                .map(PhaseAction::label)
                .distinct()
                .collect(Collectors.joining(", "));
        return labels.isEmpty() ? "; the plan has none" : "; there are " + labels;
    }
}
