package org.sami.crw.cli.plan;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.option.PlansArgument;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.FindingsText;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.testcase.TestCaseRunner;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw test}: whether plans still do what their saved test cases say. */
@Command(
        name = "test",
        mixinStandardHelpOptions = true,
        description = "Runs the test cases that are saved with plans on the engine, and lists which passed and "
                + "at which step the others failed.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:all test cases passed",
            "1:one failed, there is none, or a plan has errors",
            "2:wrong usage, or there is no such file"
        },
        footerHeading = "%nExamples:%n",
        footer = {"  crw test my-plan.json", "  crw test clv --json", "  crw test --domain uav search"})
public final class TestCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PlansArgument plans = new PlansArgument();

    @Option(
            names = "--plan",
            paramLabel = "NAME",
            defaultValue = "",
            description = "Only the test cases of this plan; its id or name.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String planName;

    @Option(names = "--json", description = "Print one JSON object.")
    private boolean json;

    /** What came of one test case; no finding where it passed. */
    private record Result(Plan plan, TestCase test, Optional<Finding> failure) {}

    @Override
    public Integer call() {
        PrintWriter err = spec.commandLine().getErr();
        Optional<PlansArgument.Read> read = plans.read(err);
        if (read.isEmpty()) {
            return notStarted(err);
        }
        PlanSource source = read.get().source();
        if (source.hasErrors()) {
            FindingsText.print(err, plans.name(), source.findings());
            return notStarted(err);
        }
        Project project = source.project().get();
        List<Result> results = run(
                chosen(source, project),
                new TestCaseRunner(project, read.get().library().vocabulary()));
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(object(results).toPrettyString());
        } else {
            results.forEach(result -> print(out, result));
            out.printf("%s: %d passed, %d failed%n", plans.name(), results.size() - failed(results), failed(results));
        }
        out.flush();
        if (results.isEmpty()) {
            err.println("crw: " + plans.name() + " has no test cases (docs/file-format.md, testCases)");
            err.flush();
        }
        return results.isEmpty() || failed(results) > 0 ? ExitCode.FINDINGS : ExitCode.OK;
    }

    private int notStarted(PrintWriter err) {
        err.println(plans.name() + ": a plan with errors is not started, in a test neither");
        err.flush();
        return ExitCode.FINDINGS;
    }

    private List<Plan> chosen(PlanSource source, Project project) {
        return planName.isEmpty() ? project.plans() : List.of(source.choose(planName));
    }

    private static List<Result> run(List<Plan> plans, TestCaseRunner runner) {
        List<Result> results = new ArrayList<>();
        for (Plan plan : plans) {
            plan.testCases().forEach(test -> results.add(new Result(plan, test, runner.run(plan, test))));
        }
        return results;
    }

    private static long failed(List<Result> results) {
        return results.stream().filter(result -> result.failure().isPresent()).count();
    }

    private void print(PrintWriter out, Result result) {
        String word = result.failure().isEmpty() ? "passed" : "FAILED";
        out.printf("%s  %s: %s%n", word, result.plan().id(), result.test().name());
        result.failure().ifPresent(failure -> FindingsText.print(out, plans.name(), List.of(failure)));
    }

    private ObjectNode object(List<Result> results) {
        ObjectNode object = JsonNodeFactory.instance.objectNode();
        object.put("source", plans.name());
        object.put("passed", results.size() - failed(results));
        object.put("failed", failed(results));
        ArrayNode list = object.putArray("testCases");
        for (Result result : results) {
            ObjectNode node = list.addObject();
            node.put("plan", result.plan().id());
            node.put("name", result.test().name());
            node.put("passed", result.failure().isEmpty());
            result.failure().ifPresent(failure -> {
                node.put("pointer", failure.pointer());
                node.put("message", failure.message());
            });
        }
        return object;
    }
}
