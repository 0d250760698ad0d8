package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.engine.SubMissionNets.parent;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.ValueType;

/** Variables and tasks over the plans of a mission (R-VAR-*). */
class VariableRulesTest {
    @Test
    void aWriteGoesToTheNearestEnclosingPlanThatDeclaresIt() {
        Plan child = new NetBuilder("child")
                .start("c")
                .variable("@own", ValueType.Simple.INTEGER)
                .build();
        Session s = new Session(NetBuilder.project(
                List.of(new VariableSpec("@global", ValueType.Simple.INTEGER, Optional.empty())),
                parent().variable("@parents", ValueType.Simple.INTEGER)
                        .variable("@own", ValueType.Simple.INTEGER)
                        .build(),
                child));
        long m = s.join("A").start("parent");
        s.news("News", "A");
        long c = s.idOf("child");

        for (String name : List.of("@own", "@parents", "@global", "@nobodys")) {
            s.step(new Input.SetVariable(c, name, new IntegerValue(1)));
        }
        s.step(new Input.SetVariable(c, "@own", new TextValue("no number")));

        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        assertThat(s.view().variable(m, "@own")).isEmpty();
        assertThat(s.view().variable(c, "@own")).contains(new IntegerValue(1));
        assertThat(s.view().variable(m, "@parents")).contains(new IntegerValue(1));
        assertThat(s.view().variable(0, "@global")).contains(new IntegerValue(1));
        assertThat(s.view().variable(m, "@nobodys")).isEmpty();
    }

    @Test
    void aGlobalThatOneMissionWritesIsReadByTheOthers() {
        Session s = new Session(NetBuilder.project(
                List.of(new VariableSpec("@global", ValueType.Simple.INTEGER, Optional.of(new IntegerValue(1)))),
                new NetBuilder("plan")
                        .start("s")
                        .output("x", "Do", Map.of("number", new FieldSource.FromVariable("@global")), Map.of())
                        .transition("go", "News")
                        .in("s", "go", "generic >= 1")
                        .out("go", "x", "take all generic")
                        .build()));
        long writes = s.start("plan");
        long reads = s.start("plan");

        s.step(new Input.SetVariable(writes, "@global", new IntegerValue(2)));
        s.news("News");

        assertThat(s.view().variable(reads, "@global")).contains(new IntegerValue(2));
        assertThat(s.activations("x"))
                .extracting(activation -> activation.value("number").orElseThrow())
                .containsExactly(new IntegerValue(2), new IntegerValue(2));
        assertThat(s.activations("x")).extracting(Activation::mission).containsExactly(writes, reads);
    }

    @Test
    void aFieldThatHoldsAnotherTypeDoesNotWriteItsVariable() {
        Session s = new Session(new NetBuilder("plan")
                .variable("@number", ValueType.Simple.INTEGER)
                .start("s")
                .output(
                        "x",
                        "Do",
                        Map.of("number", new FieldSource.FromVariable("@undeclared")),
                        Map.of("number", "@number"))
                .transition("enter", "News")
                .in("s", "enter", "relevant all")
                .out("enter", "x", "add all relevant")
                .build());
        long m = s.join("A").start("plan");
        s.step(new Input.SetVariable(m, "@undeclared", new IntegerValue(1)));
        s.news("News", "A");
        assertThat(s.view().variable(m, "@number")).contains(new IntegerValue(1));

        s.step(new Input.SetVariable(m, "@undeclared", new TextValue("no number")));
        s.news("News", "A");

        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        assertThat(s.view().variable(m, "@number")).contains(new IntegerValue(1));
    }

    @Test
    void aDeclaredVariableWithoutValueIsNotReadFromTheParent() {
        Plan child = new NetBuilder("child")
                .start("c")
                .variable("@number", ValueType.Simple.INTEGER)
                .output("c", "Do", Map.of("number", new FieldSource.FromVariable("@number")), Map.of())
                .build();
        Session s = new Session(NetBuilder.project(
                List.of(new VariableSpec("@number", ValueType.Simple.INTEGER, Optional.of(new IntegerValue(9)))),
                parent().variable("@number", ValueType.Simple.INTEGER, new IntegerValue(7))
                        .build(),
                child));
        long m = s.join("A").start("parent");

        s.news("News", "A");

        assertThat(s.view().variable(m, "@number")).contains(new IntegerValue(7));
        assertThat(s.view().variable(s.idOf("child"), "@number")).isEmpty();
        assertThat(s.latest("c").values()).isEmpty();
    }

    @Test
    void anUndeclaredVariableThatAChildWritesStaysThere() {
        Plan inner = new NetBuilder("inner").start("i").build();
        Plan child = new NetBuilder("child")
                .start("c")
                .output("c", "Do")
                .input("write", "Done", Map.of(), Map.of("value", "@nobodys"))
                .in("c", "write", "relevant all")
                .out("write", "w", "take all relevant")
                .sub("w", "inner")
                .build();
        Session s = new Session(parent().build(), child, inner);
        long m = s.join("A", "B").start("parent");
        s.news("News", "A");
        s.news("News", "B");
        Activation first = s.activations("c").get(0);
        long other = s.activations("c").get(1).mission();

        s.step(new Input.Received(
                Occurrence.answer("Done", first, List.of("A"), List.of(), Map.of("value", new IntegerValue(3)))));

        assertThat(s.view().variable(first.mission(), "@nobodys")).contains(new IntegerValue(3));
        assertThat(s.view().variable(s.idOf("inner"), "@nobodys"))
                .as("its own sub-mission reads it")
                .contains(new IntegerValue(3));
        assertThat(s.view().variable(m, "@nobodys")).isEmpty();
        assertThat(s.view().variable(other, "@nobodys")).isEmpty();
        assertThat(s.view().variable(Ids.NONE, "@nobodys")).isEmpty();
    }

    @Test
    void mappedVariablesAndTasksAreTheParents() {
        Plan child = new NetBuilder("child")
                .start("c")
                .output("c", "Do")
                .end("e")
                .task("Inner", "Measure", Map.of())
                .task("Own", "Measure", Map.of())
                .transition("over", "Done")
                .in("c", "over", "always")
                .out("over", "e", "take all task")
                .build();
        Session s = new Session(
                new NetBuilder("parent")
                        .start("s")
                        .variable("@outer", ValueType.Simple.INTEGER)
                        .task("Outer", "Measure", Map.of())
                        .sub("sub", "child", false, Map.of("Outer", "Inner"), Map.of("@inner", "@outer"))
                        .transition("send")
                        .in("s", "send", "always")
                        .out("send", "sub", "take all task")
                        .transition("back")
                        .in("sub", "back", "always")
                        .out("back", "x", "take all sub")
                        .build(),
                child);
        long m = s.start("parent");
        long c = s.idOf("child");
        assertThat(s.marking(c, "c")).isEqualTo("#Inner #Own");

        s.step(new Input.SetVariable(c, "@inner", new IntegerValue(4)));
        assertThat(s.view().variable(m, "@outer")).contains(new IntegerValue(4));
        assertThat(s.view().variable(c, "@inner")).contains(new IntegerValue(4));
        s.answer("Done", "c");

        assertThat(s.fired()).contains("back");
        assertThat(s.marking(m, "x")).isEqualTo("#Outer");
    }
}
