package org.sami.crw.sim.cli;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.testcase.TestCaseRunner;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw test}: whether plans still do what their saved test cases say. */
@Command(
        name = "test",
        mixinStandardHelpOptions = true,
        description =
                "Runs the test cases that are saved with plans on the engine, and says which went as expected and "
                        + "at which step the others did not.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:all test cases passed",
            "1:one failed, there is none, or a plan has errors",
            "2:wrong usage, or there is no such file"
        },
        footerHeading = "%nExamples:%n",
        footer = {"  crw test my-plan.json", "  crw test clv --json", "  crw test --domain uav search"})
final class TestCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "FILE|PLAN",
            description = "A project's file or folder, or a plan of the library by its id.")
    private String name;

    @Mixin
    private DomainOption domain = new DomainOption();

    @Option(
            names = "--plan",
            paramLabel = "NAME",
            defaultValue = "",
            description = "Only the test cases of this plan; its id or name.")
    private String planName;

    @Option(names = "--json", description = "Print one JSON object.")
    private boolean json;

    /** What came of one test case; no finding where it passed. */
    private record Result(Plan plan, TestCase test, Optional<Finding> failure) {}

    @Override
    public Integer call() {
        Reading<DomainLibrary> words = domain.read();
        if (words.result().isEmpty()) {
            PrintWriter err = spec.commandLine().getErr();
            FindingsText.print(err, domain.name(), words.findings());
            err.flush();
            return ExitCode.FINDINGS;
        }
        DomainLibrary library = words.result().get();
        PlanSource source = domain.find(name, library);
        PrintWriter err = spec.commandLine().getErr();
        if (source.project().isEmpty() || source.hasErrors()) {
            FindingsText.print(err, name, source.findings());
            err.println(name + ": a plan with errors is not started, in a test neither");
            err.flush();
            return ExitCode.FINDINGS;
        }
        Project project = source.project().get();
        List<Result> results = run(plans(source, project), new TestCaseRunner(project, library.vocabulary()));
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(object(results).toPrettyString());
        } else {
            results.forEach(result -> print(out, result));
            out.printf("%s: %d passed, %d failed%n", name, results.size() - failed(results), failed(results));
        }
        out.flush();
        if (results.isEmpty()) {
            err.println("crw: " + name + " has no test cases (docs/file-format.md, testCases)");
            err.flush();
        }
        return results.isEmpty() || failed(results) > 0 ? ExitCode.FINDINGS : ExitCode.OK;
    }

    private List<Plan> plans(PlanSource source, Project project) {
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
        result.failure().ifPresent(failure -> FindingsText.print(out, name, List.of(failure)));
    }

    private ObjectNode object(List<Result> results) {
        ObjectNode object = JsonNodeFactory.instance.objectNode();
        object.put("source", name);
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
