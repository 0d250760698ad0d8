package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.sami.spn.model.Plan;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.spn.model.TestStep;
import org.sami.spn.value.Value;

/** Goes through the names in the test cases of a plan. */
final class TestCaseNames {
    private final Plan plan;
    private final Function<NameUse, String> names;
    private String where = "";

    TestCaseNames(Plan plan, Function<NameUse, String> names) {
        this.plan = plan;
        this.names = names;
    }

    List<TestCase> replaced() {
        List<TestCase> cases = new ArrayList<>();
        for (TestCase testCase : plan.testCases()) {
            List<TestStep> steps = new ArrayList<>();
            for (TestStep step : testCase.steps()) {
                where = "test case \"" + testCase.name() + "\", step " + (steps.size() + 1);
                steps.add(step(step));
            }
            where = "test case \"" + testCase.name() + "\", start";
            cases.add(testCase.withStart(testCase.start().map(this::start)).withSteps(steps));
        }
        return cases;
    }

    private TestStart start(TestStart start) {
        List<StartMarking.Tokens> at = start.marking().places().stream()
                .map(p -> new StartMarking.Tokens(element(p.place()), p.generic(), p.proxies(), tasks(p.tasks())))
                .toList();
        return new TestStart(new StartMarking(at), answers("", start.values()));
    }

    private TestStep step(TestStep step) {
        if (step instanceof TestStep.Answer answer) {
            return new TestStep.Answer(element(answer.event()), reply(answer));
        }
        if (step instanceof TestStep.Occur o) {
            name(NameUse.Kind.EVENT_TYPE, o.type(), "");
            return new TestStep.Occur(
                    o.type(), element(o.answers()), o.proxies(), tasks(o.tasks()), values(o.values()));
        }
        if (step instanceof TestStep.Press press) {
            return new TestStep.Press(name(NameUse.Kind.INTERRUPT, press.interrupt(), ""), press.proxies());
        }
        return step instanceof TestStep.ExpectTokens e
                ? new TestStep.ExpectTokens(element(e.place()), e.generic(), e.proxies(), tasks(e.tasks()))
                : step;
    }

    /** Keys of values are fields, {@code eventId.field} for what is asked at the start, or variables. */
    private TestStep.Reply reply(TestStep.Answer answer) {
        if (!(answer.reply() instanceof TestStep.Reply.Values given)) {
            return answer.reply();
        }
        return new TestStep.Reply.Values(answers(answer.event(), given.values()));
    }

    private Map<String, Value> answers(String event, Map<String, Value> given) {
        Map<String, Value> values = new LinkedHashMap<>();
        given.forEach((key, value) -> values.put(key(event, key), value(value)));
        return values;
    }

    private String key(String event, String key) {
        if (key.startsWith("@")) {
            return name(NameUse.Kind.VARIABLE, key, plan.id());
        }
        int dot = key.lastIndexOf('.');
        return event.isEmpty() && dot > 0 ? element(key.substring(0, dot)) + key.substring(dot) : key;
    }

    private Map<String, Value> values(Map<String, Value> values) {
        Map<String, Value> replaced = new LinkedHashMap<>();
        values.forEach((key, value) -> replaced.put(key, value(value)));
        return replaced;
    }

    private Value value(Value value) {
        return new ValueNames(plan.id(), names).value(value, "", where);
    }

    private List<String> tasks(List<String> tasks) {
        return tasks.stream().map(t -> name(NameUse.Kind.TASK, t, plan.id())).toList();
    }

    private String element(String id) {
        return id.isEmpty() ? id : name(NameUse.Kind.ELEMENT, id, plan.id());
    }

    private String name(NameUse.Kind kind, String name, String of) {
        return names.apply(new NameUse(kind, name, of, "", where));
    }
}
