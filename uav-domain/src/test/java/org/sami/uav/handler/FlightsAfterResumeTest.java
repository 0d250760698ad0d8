package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.service.Geodesy;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;

/** What a base that goes on with the journal of a session of copters knows of their flights. */
class FlightsAfterResumeTest {
    /** To one place, then to another, where pictures are taken; one that cannot fly is not wanted any longer. */
    private static final String PLAN = """
        {"formatVersion": 1, "id": "p", "name": "p", "domain": "uav", "plans": [{"id": "p", "name": "p", "places": [
           {"id": "go", "name": "Go", "start": true},
           {"id": "near", "name": "Fly near", "outputs": [{"id": "fly-near", "type": "FlyTo",
            "fields": {"location": {"value": {"lat": 45.70225, "lon": 10.72, "alt": 30}}}}]},
           {"id": "far", "name": "Fly far", "outputs": [{"id": "fly-far", "type": "FlyTo",
            "fields": {"location": {"value": {"lat": LATITUDE, "lon": 10.72, "alt": 30}}}}]},
           {"id": "look", "name": "Look", "outputs": [{"id": "pictures", "type": "LookAround"}]},
           {"id": "over", "name": "Over", "end": true}],
          "transitions": [{"id": "begin"},
           {"id": "there", "inputs": [{"id": "reached", "type": "ReachedLocation"}]},
           {"id": "cannot", "inputs": [{"id": "cannot-fly", "type": "CannotFly"}]},
           {"id": "far-there", "inputs": [{"id": "far-reached", "type": "ReachedLocation"}]},
           {"id": "seen", "inputs": [{"id": "picture", "type": "PictureTaken"}]}],
          "inEdges": [
           {"id": "a", "place": "go", "transition": "begin", "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]},
           {"id": "b", "place": "near", "transition": "there", "requirements": [{"match": "all", "kind": "relevant"}]},
           {"id": "c", "place": "far", "transition": "cannot", "requirements": [{"match": "all", "kind": "relevant"}]},
           {"id": "g", "place": "far", "transition": "far-there", "requirements": [{"match": "all", "kind": "relevant"}]},
           {"id": "h", "place": "look", "transition": "seen", "requirements": [{"match": "all", "kind": "relevant"}]}],
          "outEdges": [
           {"id": "d", "transition": "begin", "place": "near", "requirements": [{"action": "take", "n": "all", "kind": "any-proxy"}]},
           {"id": "e", "transition": "there", "place": "far", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]},
           {"id": "f", "transition": "cannot", "place": "over", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]},
           {"id": "i", "transition": "far-there", "place": "look", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]},
           {"id": "j", "transition": "seen", "place": "over", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]}]}]}
        """;

    private static final Answer YES = new Answer.YesNo(true);
    private static final Answer NO = new Answer.YesNo(false);

    @TempDir
    private Path folder;

    private JournalledBase base(Project project, double percent) throws IOException {
        return new JournalledBase(folder.resolve("session.journal"), project, percent);
    }

    private static Project plan(double latitude) {
        return new ProjectReader(UavRuns.DOMAIN.vocabulary())
                .read(PLAN.replace("LATITUDE", String.valueOf(latitude)))
                .orThrow();
    }

    private static void start(JournalledBase base, String plan, Map<String, Value> values) {
        base.post(new Input.StartMission(plan, plan, values));
        base.pass(1);
    }

    @Test
    void copterThatComesHomeForWantOfChargeGetsThereUnderTheNextBase() throws IOException {
        try (JournalledBase base = base(plan(45.718), 36)) {
            start(base, "p", Map.of());
            base.await("LongWay");
            while (!base.ask(view -> view.missions()).isEmpty()) {
                base.pass(1);
            }
            base.pass(5);
            base.restart();
            assertThat(base.copter().altM().orElseThrow()).isGreaterThan(10);
            base.pass(120);

            assertThat(base.copter().altM()).hasValue(0);
            assertThat(Geodesy.distanceM(base.fleet.boats().get(0).position(), GeoPoint.of(45.7, 10.72)))
                    .isLessThan(3);
            base.restart();
            base.pass(60);
            assertThat(base.copter().altM()).hasValue(0);
        }
    }

    @Test
    void copterThatHasHadAnotherBatterySinceIsNotSentHomeByTheNextBase() throws IOException {
        try (JournalledBase base = base(plan(45.718), 36)) {
            start(base, "p", Map.of());
            base.await("LongWay");
            while (!base.ask(view -> view.missions()).isEmpty()) {
                base.pass(1);
            }
            base.pass(5);
            base.copter().setBatteryPercent(90);
            base.restart();
            base.pass(120);

            assertThat(base.copter().altM().orElseThrow()).isGreaterThan(10);
        }
    }

    @Test
    void yesToAFlightHoldsForWhatIsDoneAtItsEndUnderTheNextBase() throws IOException {
        try (JournalledBase base = base(plan(45.708), 34)) {
            start(base, "p", Map.of());
            base.answer("LongWay", YES);
            base.pass(20);
            base.restart();
            while (!base.ask(view -> view.missions()).isEmpty() && base.times("LongWay") < 2) {
                base.pass(1);
            }

            assertThat(base.times("LongWay")).isEqualTo(1);
            assertThat(base.fleet.boats().get(0).position().latDeg()).isGreaterThan(45.7079);
        }
    }

    @Test
    void taskAtWhichTheCopterHasFailedOnceIsTriedOnceMoreUnderTheNextBase() throws IOException {
        try (JournalledBase base = base(UavRuns.DOMAIN.combined(), 40)) {
            start(
                    base,
                    "search",
                    Map.of("fly-there.speed", new RealValue(8), "search-there.radius", new RealValue(50)));
            base.answer(
                    "CreateLocations",
                    new Answer.Fields(Map.of("locations", new ListValue(List.of(GeoPoint.of(45.72, 10.72))))));
            base.answer("ChooseAllocation", new Answer.Option(0));
            base.answer("LongWay", NO);
            base.await("ApproveRetry");
            base.restart();
            base.pass(5);
            base.answer("ApproveRetry", YES);
            base.answer("ChooseAllocation", new Answer.Option(0));
            base.answer("LongWay", NO);
            base.pass(5);

            assertThat(base.messages).anyMatch(text -> text.contains("copter1 failed at it twice. It is left out"));
        }
    }
}
