package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.TextValue;

/** A person drives a boat that a mission has sent along a path; plans hear of it, and the path goes on afterwards. */
class TakeOverTest {
    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void aBoatOnItsWay() {
        world.addBoat("a", 0, 0);
        world.run(1);
        GeoPath north =
                new GeoPath(List.of(Geodesy.offset(TestWorld.HOME, 0, 30), Geodesy.offset(TestWorld.HOME, 0, 60)));
        world.happens(
                engine,
                new TestActivations("ProxyExecutePath")
                        .with("paths", ProxyMaps.toValue(Map.of("a", north)))
                        .of("a")
                        .effect());
        world.run(5);
    }

    @Test
    void plansHearOnceThatAPersonHasTheBoatAndOnceThatItIsBack() {
        driveByHand(5);
        assertThat(engine.received("ProxyTakenOver")).singleElement().satisfies(news -> {
            assertThat(news.proxies()).containsExactly("a");
            assertThat(news.values()).containsEntry("by", new TextValue("operator"));
            assertThat(news.mission()).isZero();
        });
        assertThat(engine.received("ProxyReleased")).isEmpty();

        boat().release();
        boat().release();
        world.run(1);

        assertThat(engine.received("ProxyReleased"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("a"));
        assertThat(engine.received("ProxyTakenOver")).hasSize(1);
    }

    @Test
    void theCommandThatWasInterruptedReturnsAfterwards() {
        driveByHand(20);
        assertThat(boat().explain().text()).contains("driven by hand; one command waits");
        assertThat(engine.received("ProxyPathCompleted")).isEmpty();

        boat().release();
        world.run(120);

        assertThat(engine.received("ProxyPathCompleted")).hasSize(1);
        assertThat(engine.received("ProxyPathFailed")).isEmpty();
    }

    /** Nobody drives by hand any longer: the person's window died with the base. */
    @Test
    void aBaseThatStartsAnewSaysThatTheBoatIsBack() {
        world.host.post(new Input.Remember(0, "taken-over/b", new TextValue("operator")));

        world.addBoat("b", 5, 0);
        world.run(2);

        assertThat(engine.received("ProxyReleased"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("b"));
    }

    private void driveByHand(double seconds) {
        for (int i = 0; i < Math.round(seconds); i++) {
            boat().teleoperate(0.5, 0.3);
            world.run(1);
        }
    }

    private BoatProxy boat() {
        return world.boats.find("a").orElseThrow();
    }
}
