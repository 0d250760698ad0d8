package org.sami.lessons.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Match;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.WaitFor;
import org.sami.spn.value.IntegerValue;

/** Each word of a script makes the edit that an author would make; what is wrong is named with its element. */
class EditScriptTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private static Project start() {
        Plan plan = new PlanBuilder("p").start("a").transition("t").end("b").build();
        return new Project("x", "", "crw", List.of(), List.of(), List.of(plan));
    }

    private static EditScript script(String elements) {
        return EditScript.read("s.json", "[" + elements.replace('\'', '"') + "]")
                .orThrow();
    }

    private static Plan after(String elements) {
        return script(elements).applyTo(start(), DOMAIN).orThrow().plan("p").orElseThrow();
    }

    private static String refusal(String elements) {
        return script(elements)
                .applyTo(start(), DOMAIN)
                .refusal()
                .map(ScriptRun.Refusal::message)
                .orElse("");
    }

    private static List<String> findings(String text) {
        Reading<EditScript> reading = EditScript.read("s.json", text.replace('\'', '"'));
        assertThat(reading.result()).isEmpty();
        return reading.findings().stream().map(EditScriptTest::line).toList();
    }

    private static String line(Finding finding) {
        return finding.location().map(at -> at.file() + ":" + at.line() + " ").orElse("") + finding.message();
    }

    @Test
    void aNewVertexHasTheIdAndTheNameOfTheScript() {
        Plan plan = after("""
                {'do': 'add', 'item': 'palette-blank-place', 'at': [300, 80], 'id': 'c', 'name': 'Wait'},
                {'do': 'add', 'item': 'palette-blank-transition', 'id': 'u'},
                {'do': 'connect', 'from': 'c', 'to': 'u', 'id': 'c-u-edge'}
                """);

        assertThat(plan.place("c").orElseThrow().name()).isEqualTo("Wait");
        assertThat(plan.layout()).containsEntry("c", new LayoutPoint(300, 80));
        assertThat(plan.inEdges())
                .anyMatch(e -> e.id().equals("c-u-edge")
                        && e.place().equals("c")
                        && e.transition().equals("u"));
    }

    @Test
    void anEventBringsWhatThePaletteDrawsWithIt() {
        Plan plan = after("""
                {'do': 'add', 'item': 'palette-event-connect-existing-proxy-id', 'id': 'c', 'event': 'connect', 'name': 'Connect'}
                """);

        assertThat(plan.place("c").orElseThrow().outputs().get(0).id()).isEqualTo("connect");
        assertThat(plan.transition("proxy-connected")).isPresent();
    }

    @Test
    void anEventAloneBringsNothingElse() {
        Plan plan = after("""
                {'do': 'add', 'item': 'palette-event-connect-existing-proxy-id', 'on': 'a', 'id': 'connect', 'sequence': 'alone'}
                """);

        assertThat(plan.place("a").orElseThrow().outputs().get(0).id()).isEqualTo("connect");
        assertThat(plan.transitions()).hasSize(1);
    }

    @Test
    void requirementsAreAllThatTheEdgeHasAfterwards() {
        Plan plan = after("""
                {'do': 'connect', 'from': 'a', 'to': 't'},
                {'do': 'connect', 'from': 't', 'to': 'b', 'id': 'out'},
                {'do': 'require', 'edge': 'a>t', 'requirements': [{'kind': 'any-proxy', 'match': 'at-least', 'n': 2}]},
                {'do': 'require', 'edge': 'out', 'requirements': [{'kind': 'any-proxy', 'action': 'take', 'n': 'all'}]}
                """);

        assertThat(plan.inEdges().get(0).requirements())
                .containsExactly(InRequirement.of(TokenKind.ANY_PROXY, Match.AT_LEAST, 2));
        assertThat(plan.outEdges().get(0).requirements()).hasSize(1).allMatch(OutRequirement::takesAll);
    }

    @Test
    void fieldsComeFromValuesVariablesAndTheOperator() {
        String add =
                "{'do': 'add', 'item': 'palette-event-start-system-timer', 'on': 'a', 'id': 'e', 'sequence': 'alone'},";
        assertThat(source(add + "{'do': 'field', 'event': 'e', 'field': 'duration', 'source': {'value': 'PT10S'}}"))
                .isInstanceOf(FieldSource.Fixed.class);
        assertThat(source(add
                        + "{'do': 'variable', 'name': '@x', 'type': 'duration', 'initial': 'PT1S'},"
                        + "{'do': 'field', 'event': 'e', 'field': 'duration', 'source': {'variable': '@x'}}"))
                .isEqualTo(new FieldSource.FromVariable("@x"));
        assertThat(source(add + "{'do': 'field', 'event': 'e', 'field': 'duration', 'source': {'ask': 'editable'}}"))
                .isEqualTo(new FieldSource.Asked(Optional.empty(), true));
        assertThat(after(add
                                + "{'do': 'field', 'event': 'e', 'field': 'duration', 'source': {'value': 'PT10S'}},"
                                + "{'do': 'field', 'event': 'e', 'field': 'duration', 'source': null}")
                        .place("a")
                        .orElseThrow()
                        .outputs()
                        .get(0)
                        .fields())
                .isEmpty();
    }

    private static FieldSource source(String elements) {
        Map<String, FieldSource> fields =
                after(elements).place("a").orElseThrow().outputs().get(0).fields();
        assertThat(fields).hasSize(1);
        return fields.values().iterator().next();
    }

    @Test
    void marksOfVerticesChange() {
        Plan plan = after("""
                {'do': 'rename', 'what': 'a', 'name': 'Begin'},
                {'do': 'start', 'what': 'a', 'on': false},
                {'do': 'end', 'what': 'b', 'on': false},
                {'do': 'mode', 'what': ['t', 'b'], 'mode': 'recovery'},
                {'do': 'wait-for', 'what': 't', 'waitFor': 'all'},
                {'do': 'move', 'what': 'b', 'at': [7, 8]}
                """);

        assertThat(plan.place("a").orElseThrow().name()).isEqualTo("Begin");
        assertThat(plan.places()).noneMatch(p -> p.start() || p.end());
        assertThat(plan.place("b").orElseThrow().mode()).isEqualTo(Mode.RECOVERY);
        assertThat(plan.transition("t").orElseThrow().waitFor()).isEqualTo(WaitFor.ALL);
        assertThat(plan.layout()).containsEntry("b", new LayoutPoint(7, 8));
    }

    @Test
    void elementsVariablesAndTasksAreDeleted() {
        Plan plan = after("""
                {'do': 'variable', 'name': '@n', 'type': 'integer', 'initial': 3},
                {'do': 'task', 'name': 'Look', 'class': 'Camera', 'fields': {'location': {'lat': 1, 'lon': 2}}},
                {'do': 'connect', 'from': 'a', 'to': 't'},
                {'do': 'delete', 'what': ['a>t', 'b', '@n', 'Look']}
                """);

        assertThat(plan.inEdges()).isEmpty();
        assertThat(plan.place("b")).isEmpty();
        assertThat(plan.variables()).isEmpty();
        assertThat(plan.tasks()).isEmpty();
    }

    @Test
    void aVariableThatIsThereGetsAnotherFirstValue() {
        Plan plan = after("""
                {'do': 'variable', 'name': '@n', 'type': 'integer', 'initial': 3},
                {'do': 'variable', 'name': '@n', 'type': 'integer', 'initial': 4}
                """);

        assertThat(plan.variables().get(0).initial()).contains(new IntegerValue(4));
    }

    @Test
    void aMarkupIsGivenAndTakenAway() {
        String marked = """
                {'do': 'add', 'item': 'palette-event-operator-select-boat', 'on': 'a', 'id': 'e', 'sequence': 'alone'},
                {'do': 'markup', 'event': 'e', 'type': 'Priority', 'options': {'rank': 'HIGH'}}
                """;
        assertThat(after(marked).place("a").orElseThrow().outputs().get(0).markups())
                .hasSize(1);
        assertThat(after(marked + ",{'do': 'markup', 'event': 'e', 'type': 'Priority', 'on': false}")
                        .place("a")
                        .orElseThrow()
                        .outputs()
                        .get(0)
                        .markups())
                .isEmpty();
    }

    @Test
    void aPlanRunsAnother() {
        Project project = script("""
                        {'do': 'plan', 'id': 'child', 'name': 'Child'},
                        {'do': 'add', 'item': 'palette-blank-place', 'id': 'c'},
                        {'do': 'plan', 'open': 'p'},
                        {'do': 'add', 'item': 'palette-sub-mission-child', 'on': 'a', 'id': 'run'},
                        {'do': 'sub-mission', 'what': 'run', 'shared': true}
                        """).applyTo(start(), DOMAIN).orThrow();

        assertThat(project.plan("child").orElseThrow().place("c")).isPresent();
        assertThat(project.plan("p")
                        .orElseThrow()
                        .place("a")
                        .orElseThrow()
                        .subMissions()
                        .get(0))
                .matches(sub -> sub.id().equals("run") && sub.plan().equals("child") && sub.shared());
    }

    @Test
    void undoTakesTheLastEditBackAndOtherCommandsChangeNothing() {
        Plan plan = after("""
                {'do': 'delete', 'what': ['t']},
                {'do': 'command', 'id': 'net-fit'},
                {'do': 'command', 'id': 'undo'}
                """);

        assertThat(plan.transition("t")).isPresent();
        assertThat(refusal("{'do': 'command', 'id': 'undo'}"))
                .isEqualTo("Element 1 of the script (command undo): There is nothing to undo");
    }

    @Test
    void eachElementHasTheProjectAfterIt() {
        ScriptRun run = script("{'do': 'select', 'what': ['a']}, {'do': 'delete', 'what': 't'}")
                .applyTo(start(), DOMAIN);

        assertThat(run.done().get(0).project()).isEqualTo(start());
        assertThat(run.done().get(0).edit()).isEmpty();
        assertThat(run.done().get(1).project().plan("p").orElseThrow().transition("t"))
                .isEmpty();
        assertThat(run.done().get(1).edit()).isPresent();
    }

    @Test
    void whatCannotBeDoneIsRefusedWithItsElementAndWhatWasDoneBeforeStays() {
        ScriptRun run = script(
                        "{'do': 'rename', 'what': 'a', 'name': 'Go'}, {'do': 'rename', 'what': 'aa', 'name': 'x'}")
                .applyTo(start(), DOMAIN);

        assertThat(run.refusal())
                .contains(
                        new ScriptRun.Refusal(
                                1,
                                "/1/what",
                                "Element 2 of the script (rename aa): The plan \"p\" has no place or transition \"aa\"; is a meant?"));
        assertThat(run.project()
                        .plan("p")
                        .orElseThrow()
                        .place("a")
                        .orElseThrow()
                        .name())
                .isEqualTo("Go");
        assertThatThrownBy(run::orThrow).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void refusalsSayWhatMayHaveBeenMeant() {
        assertThat(refusal("{'do': 'add', 'item': 'palette-event-proxy-goto-pont'}"))
                .contains("is palette-event-proxy-goto-point")
                .contains("meant?");
        assertThat(refusal("{'do': 'connect', 'from': 'a', 'to': 'b'}")).contains("both places");
        assertThat(refusal("{'do': 'require', 'edge': 'a>t', 'requirements': []}"))
                .contains("has no edge \"a>t\"");
        assertThat(refusal("{'do': 'connect', 'from': 'a', 'to': 't', 'id': 'b'}"))
                .contains("is used already");
        assertThat(refusal("{'do': 'connect', 'from': 'a', 'to': 't'},"
                        + "{'do': 'require', 'edge': 'a>t', 'requirements': [{'kind': 'any-boat'}]}"))
                .contains("\"any-boat\" is none of");
        assertThat(refusal("{'do': 'plan', 'open': 'q'}")).contains("no plan \"q\"");
        assertThat(refusal(
                        "{'do': 'add', 'item': 'palette-event-start-system-timer', 'on': 'a', 'id': 'e', 'sequence': 'alone'},"
                                + "{'do': 'field', 'event': 'e', 'field': 'duration', 'source': {'value': 3}}"))
                .startsWith("Element 2 of the script (field duration of e): ");
    }

    @Test
    void whatIsWrongInTheFileIsNamedWithItsLine() {
        assertThat(findings("[\n{'do': 'conect', 'from': 'a', 'to': 't'}]"))
                .singleElement()
                .asString()
                .startsWith("s.json:2 \"conect\" is none of: add, connect,")
                .endsWith("is connect meant?");
        assertThat(findings("[\n\n{'do': 'connect', 'frm': 'a', 'to': 't'}]"))
                .containsExactly(
                        "s.json:3 The member \"from\" is missing",
                        "s.json:3 \"frm\" is not known here; known are say, do, from, to, id; is from meant?");
        assertThat(findings("[{'do': 'delete'}]"))
                .containsExactly("s.json:1 The member \"what\" is missing: a list of ids");
        assertThat(findings("[{'do': 'add', 'item': 'x', 'on': 'a', 'name': 'n'}]"))
                .singleElement()
                .asString()
                .contains("\"name\" goes with a new vertex");
        assertThat(findings("[{'do': 'add', 'item': 'x', 'at': 3}]"))
                .containsExactly("s.json:1 A vertex is drawn at [x, y]");
        assertThat(findings("[{'do': ")).hasSize(1);
        assertThat(findings("{'elements': []}")).containsExactly("s.json:1 A script is a list of elements");
    }

    @Test
    void aScriptMayStandInAnObjectAsASolutionDoes() {
        Reading<EditScript> reading = EditScript.read(
                "s.json",
                "{\"from\": \"start\", \"says\": \"x\", \"script\": [{\"do\": \"delete\", \"what\": [\"t\"]}]}");

        assertThat(reading.orThrow().elements()).hasSize(1);
    }
}
