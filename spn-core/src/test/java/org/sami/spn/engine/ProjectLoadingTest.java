package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Projects loaded while missions run (decision 0176, docs/session.md). */
class ProjectLoadingTest {
    private static final VariableSpec SPEED = integer("@speed", 1);

    private static VariableSpec integer(String name, long initial) {
        return new VariableSpec(name, ValueType.Simple.INTEGER, Optional.of(new IntegerValue(initial)));
    }

    /** A plan that runs a leg and goes to the place of that name when it is back. */
    private static Plan tour(String then) {
        return new NetBuilder("tour")
                .start("begin")
                .output("begin", "Approve")
                .sub("work", "leg")
                .places(then)
                .end("end")
                .transition("go", "Yes")
                .in("begin", "go", "generic >= 1")
                .out("go", "work", "take all any")
                .transition("back")
                .in("work", "back", "generic >= 1")
                .out("back", then, "take all sub")
                .transition("stop", "News")
                .in(then, "stop", "generic >= 1")
                .out("stop", "end", "take all any")
                .build();
    }

    /** A plan that waits in the place of that name for something done. */
    private static Plan leg(String place) {
        return new NetBuilder("leg")
                .start(place)
                .output(place, "Do")
                .end("done")
                .transition("finish", "Done")
                .in(place, "finish", "generic >= 1")
                .out("finish", "done", "take all any")
                .build();
    }

    private static Input load(Project project) {
        return new Input.LoadProject(new ProjectWriter(TestVocabulary.TEST).text(project));
    }

    private Optional<Value> global(String name) {
        return s.view().variable(Ids.NONE, name);
    }

    private static final Project OLD = NetBuilder.project(List.of(SPEED), tour("old"), leg("slow"));
    private static final Project MENDED = NetBuilder.project(List.of(SPEED), tour("new"), leg("fast"));

    private final Session s = new Session(OLD);

    @Test
    void runningMissionsKeepTheirPlansAndLaterOnesTakeTheLoaded() {
        long old = s.start("tour");

        List<Effect> effects = s.step(load(MENDED));
        long mended = s.start("tour");

        EngineView view = s.view();
        assertThat(effects).containsExactly(new Effect.ProjectLoaded(2, MENDED));
        assertThat(view.planOf(old)).contains(OLD.plan("tour").orElseThrow());
        assertThat(view.planOf(mended)).contains(MENDED.plan("tour").orElseThrow());
        assertThat(view.mission(old).orElseThrow().projectVersion()).isEqualTo(1);
        assertThat(view.mission(mended).orElseThrow().projectVersion()).isEqualTo(2);
        assertThat(view.project()).isEqualTo(MENDED);
        assertThat(view.projectVersion()).isEqualTo(2);
        assertThat(view.plan("tour")).contains(MENDED.plan("tour").orElseThrow());
    }

    @Test
    void aSubMissionThatStartsLaterIsOfTheProjectOfItsParent() {
        s.start("tour");
        s.step(load(MENDED));
        s.start("tour");

        s.answer("Yes", s.activations("begin").get(0));
        s.answer("Yes", s.activations("begin").get(1));

        assertThat(s.effects().stream().filter(Effect.MissionStarted.class::isInstance))
                .containsExactly(
                        new Effect.MissionStarted(1, Ids.NONE, "", "tour", "tour", 1),
                        new Effect.MissionStarted(2, Ids.NONE, "", "tour", "tour", 2),
                        new Effect.MissionStarted(3, 1, "work", "leg", "leg", 1),
                        new Effect.MissionStarted(4, 2, "work", "leg", "leg", 2));
        s.answer("Done", "slow");
        s.answer("Done", "fast");
        assertThat(s.marking(1)).containsOnlyKeys("old");
        assertThat(s.marking(2)).containsOnlyKeys("new");
    }

    @Test
    void aPlanThatIsGoneRunsOnAndIsNotStartedAnyMore() {
        long old = s.start("tour");
        s.step(load(NetBuilder.project(List.of(SPEED), leg("fast"))));

        assertThat(s.start("tour")).isEqualTo(Ids.NONE);
        assertThat(notes(s.last(), NoteKind.REJECTED_INPUT)).containsExactly("There is no plan 'tour'");
        s.answer("Yes", "begin");
        assertThat(s.marking(old)).containsOnlyKeys("work");
        assertThat(s.missionOf("leg").orElseThrow().marking()).containsOnlyKeys("slow");
    }

    @Test
    void aProjectEqualToTheNewestIsNoNewVersion() {
        s.start("tour");
        byte[] without = afterNothing();

        assertThat(s.step(load(OLD))).containsExactly(new Effect.ProjectLoaded(1, OLD));

        assertThat(StateCodec.encode(s.state())).isEqualTo(without);
    }

    @Test
    void aGlobalKeepsItsValueANewOneBeginsAndOneThatIsGoneEnds() {
        s.step(new Input.SetVariable(Ids.NONE, "@speed", new IntegerValue(5)));

        List<Effect> effects = s.step(load(
                NetBuilder.project(List.of(integer("@speed", 9), integer("@depth", 3)), tour("new"), leg("fast"))));

        assertThat(global("@speed")).contains(new IntegerValue(5));
        assertThat(effects).contains(new Effect.VariableWritten(Ids.NONE, "@depth", new IntegerValue(3)));
        assertThat(notes(effects, NoteKind.GLOBAL_KEPT))
                .singleElement()
                .satisfies(text ->
                        assertThat(text).contains("@speed").contains("5").contains("9"));

        s.step(load(NetBuilder.project(List.of(integer("@depth", 3)), tour("new"), leg("fast"))));
        assertThat(global("@speed")).isEmpty();
        s.step(load(MENDED));
        assertThat(global("@speed")).contains(new IntegerValue(1));
        assertThat(s.view().globals()).containsExactly(Map.entry("@speed", new IntegerValue(1)));
    }

    @Test
    void aGlobalThatIsGoneLivesAsLongAsAMissionThatDeclaresItAndForNoOther() {
        long old = s.start("tour");
        s.step(load(NetBuilder.project(List.of(), tour("new"), leg("fast"))));
        long mended = s.start("tour");

        s.step(new Input.SetVariable(old, "@speed", new IntegerValue(7)));

        EngineView view = s.view();
        assertThat(view.variable(old, "@speed")).contains(new IntegerValue(7));
        assertThat(view.variable(mended, "@speed")).isEmpty();
        assertThat(view.globals()).isEmpty();

        s.step(new Input.AbortMission(old));
        s.step(load(MENDED));
        assertThat(global("@speed")).contains(new IntegerValue(1));
    }

    @Test
    void noGlobalChangesItsTypeUnderARunningMission() {
        long old = s.start("tour");
        Project retyped = NetBuilder.project(
                List.of(new VariableSpec("@speed", ValueType.Simple.TEXT, Optional.of(new TextValue("fast")))),
                tour("new"),
                leg("fast"));
        byte[] without = afterNothing();

        assertThat(notes(s.step(load(retyped)), NoteKind.REJECTED_INPUT))
                .singleElement()
                .satisfies(text -> assertThat(text)
                        .contains("mission 1")
                        .contains("@speed")
                        .contains("integer")
                        .contains("text"));
        assertThat(StateCodec.encode(s.state())).isEqualTo(without);

        s.step(new Input.AbortMission(old));
        assertThat(s.step(load(retyped))).contains(new Effect.ProjectLoaded(2, retyped));
        assertThat(global("@speed")).contains(new TextValue("fast"));
    }

    @Test
    void aDocumentThatCannotBeReadOrIsOfAnotherDomainIsRefused() {
        s.start("tour");

        for (String document : List.of(
                "",
                "{\"formatVersion\": 1",
                new ProjectWriter(TestVocabulary.TEST)
                        .text(MENDED)
                        .replace("\"domain\": \"test\"", "\"domain\": \"air\""))) {
            List<Effect> effects = s.step(new Input.LoadProject(document));
            assertThat(effects).hasSize(1);
            assertThat(notes(effects, NoteKind.REJECTED_INPUT))
                    .singleElement()
                    .satisfies(text -> assertThat(text).contains("cannot be loaded"));
        }
        assertThat(s.view().projectVersion()).isEqualTo(1);
    }

    @Test
    void inputEventsOfOldAndNewPlansAreToldApart() {
        Project other = NetBuilder.project(
                List.of(SPEED),
                new NetBuilder("tour")
                        .start("watch")
                        .end("end")
                        .transition("seen", "Other")
                        .in("watch", "seen", "generic >= 1")
                        .out("seen", "end", "take all any")
                        .build());
        s.start("tour");
        s.step(load(other));
        long watching = s.start("tour");

        assertThat(s.view().awaits("Other")).isTrue();
        s.news("Other");

        assertThat(s.outcome(watching)).contains(Outcome.ENDED);
        s.answer("Yes", s.activations("begin").get(0));
        assertThat(s.marking(1)).containsOnlyKeys("work");
    }

    @Test
    void aStateOfSeveralProjectsComesBackFromItsBytesWithTheirDocuments() {
        Project third = NetBuilder.project(List.of(SPEED), tour("third"), leg("third"));
        Input loadMended = load(MENDED);
        Input loadThird = load(third);
        s.start("tour");
        s.step(loadMended);
        s.start("tour");
        s.step(loadThird);
        byte[] bytes = StateCodec.encode(s.state());

        assertThatThrownBy(() -> StateCodec.decode(bytes, s.engine()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("project");
        EngineState decoded = StateCodec.decode(
                bytes,
                s.engine(),
                sha256 -> List.of(loadMended, loadThird).stream()
                        .map(Input.LoadProject.class::cast)
                        .filter(l -> l.sha256().equals(sha256))
                        .map(Input.LoadProject::document)
                        .findFirst());

        assertThat(StateCodec.encode(decoded)).isEqualTo(bytes);
        assertThat(StateCodec.encode(s.state().copy())).isEqualTo(bytes);
        for (EngineState state : List.of(decoded, s.state().copy())) {
            Session again = new Session(s.engine());
            again.replaceState(state);
            again.step(new Input.StartMission("tour", "x", Map.of()));
            EngineView view = s.engine().view(state);
            assertThat(view.planOf(1)).contains(OLD.plan("tour").orElseThrow());
            assertThat(view.planOf(2)).contains(MENDED.plan("tour").orElseThrow());
            assertThat(view.planOf(3)).contains(third.plan("tour").orElseThrow());
        }
    }

    @Test
    void aKeyTellsOfWhichProjectsMissionsAreAndNotHowOftenOneWasLoaded() {
        Session loadedBefore = new Session(OLD);
        loadedBefore.step(load(MENDED));
        loadedBefore.start("tour");
        Session loadedTwice = new Session(OLD);
        loadedTwice.step(load(MENDED));
        loadedTwice.step(load(NetBuilder.project(List.of(SPEED), leg("third"))));
        loadedTwice.step(load(MENDED));
        loadedTwice.start("tour");
        s.start("tour");
        s.step(load(MENDED));

        assertThat(StateKey.of(loadedTwice.state())).isEqualTo(StateKey.of(loadedBefore.state()));
        assertThat(StateKey.of(s.state())).isNotEqualTo(StateKey.of(loadedBefore.state()));
    }

    @Test
    void aProjectOfWhichNothingRunsAnyLongerIsNotInTheStatesBytes() {
        Input loadMended = load(MENDED);
        s.step(loadMended);
        s.step(load(NetBuilder.project(List.of(SPEED), tour("third"), leg("third"))));

        assertThat(new String(StateCodec.encode(s.state()), StandardCharsets.ISO_8859_1))
                .doesNotContain(((Input.LoadProject) loadMended).sha256());
    }

    @Test
    void onlyASessionThatLoadedAProjectIsOfTheFormThatNamesOne() {
        s.start("tour");
        assertThat(version(StateCodec.encode(s.state()))).isEqualTo(5);

        s.step(load(MENDED));
        assertThat(version(StateCodec.encode(s.state()))).isEqualTo(6);
    }

    /** What the state is like after an input that does nothing. */
    private byte[] afterNothing() {
        EngineState copy = s.state().copy();
        s.engine().step(copy, 0, new Input.TimeReached());
        return StateCodec.encode(copy);
    }

    private static int version(byte[] state) {
        return ByteBuffer.wrap(state).getInt(4);
    }

    private static List<String> notes(List<Effect> effects, NoteKind kind) {
        List<String> notes = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.Noted noted && noted.kind() == kind) {
                notes.add(noted.message());
            }
        }
        return notes;
    }
}
