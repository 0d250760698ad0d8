package org.sami.uav.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostClock;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.protocol.Input;

/** News of links, in bases that go on with the state of the one before. */
class AircraftNewsTest {
    /** Waits for each of the news where it starts. */
    private static final String PLAN = """
            {"formatVersion": 1, "id": "p", "name": "P", "domain": "uav", "plans": [{
              "id": "p",
              "places": [{"id": "start", "start": true}, {"id": "end", "end": true}],
              "transitions": [
                {"id": "lost", "inputs": [{"id": "l", "type": "LinkLost"}]},
                {"id": "back", "inputs": [{"id": "b", "type": "LinkBack"}]}],
              "inEdges": [
                {"id": "il", "place": "start", "transition": "lost",
                  "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]},
                {"id": "ib", "place": "start", "transition": "back",
                  "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}],
              "outEdges": [
                {"id": "ol", "transition": "lost", "place": "start",
                  "requirements": [{"action": "take", "n": "all", "kind": "generic"}]},
                {"id": "ob", "transition": "back", "place": "start",
                  "requirements": [{"action": "take", "n": "all", "kind": "generic"}]}]}]}
            """;

    private final Engine engine = new Engine(
            UavRuns.DOMAIN.vocabulary(),
            new ProjectReader(UavRuns.DOMAIN.vocabulary()).read(PLAN).orThrow());
    private final ArrayDeque<Runnable> work = new ArrayDeque<>();
    private final List<String> told = new ArrayList<>();
    private EngineState state = engine.newState();
    private EngineHost host = base();
    private AircraftNews news = new AircraftNews(host);

    private static final class Standing implements HostClock {
        @Override
        public long nowMillis() {
            return 0;
        }

        @Override
        public void wakeAt(long millis, Runnable action) {}
    }

    private EngineHost base() {
        EngineHost made = EngineHostBuilder.of(engine, state)
                .clock(new Standing())
                .executor(work::add)
                .build();
        made.addListener((index, atMillis, input, effects, view) -> {
            if (input instanceof Input.Received received) {
                told.add(received.occurrence().type());
            }
        });
        made.resume();
        return made;
    }

    private void begin() {
        host.post(new Input.ProxyJoined("copter1"));
        host.post(new Input.StartMission("p", "one", Map.of()));
        runAll();
    }

    private void startAgain() {
        state = state.copy();
        host = base();
        news = new AircraftNews(host);
    }

    private void becomes(LinkState link) {
        news.accept(new FleetEvent.LinkChanged(BoatStatus.unknown("copter1").with(link, "boot")));
        runAll();
    }

    private void runAll() {
        for (Runnable next = work.poll(); next != null; next = work.poll()) {
            next.run();
        }
    }

    @Test
    void lostLinkThatComesBackAfterARestartOfTheBaseIsToldOnce() {
        begin();
        becomes(LinkState.LINKED);
        becomes(LinkState.LOST);
        startAgain();
        becomes(LinkState.LINKED);
        startAgain();
        becomes(LinkState.LINKED);

        assertThat(told).containsExactly(UavEvents.LINK_LOST, UavEvents.LINK_BACK);
    }

    @Test
    void linkThatIsStillLostAfterARestartOfTheBaseIsNotToldAgain() {
        begin();
        becomes(LinkState.LOST);
        startAgain();
        becomes(LinkState.LOST);

        assertThat(told).containsExactly(UavEvents.LINK_LOST);
    }

    @Test
    void linkThatComesFirstIsNotBack() {
        begin();
        becomes(LinkState.LINKED);

        assertThat(told).isEmpty();
    }
}
