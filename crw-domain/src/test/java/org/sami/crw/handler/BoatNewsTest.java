package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Comparisons of distances, messages, and news of boats. */
class BoatNewsTest extends TwoBoatsOnHandlers {
    @Test
    void aBoatsDistanceIsComparedWithTheThreshold() {
        Value points = ProxyMaps.toValue(Map.of("west", at(-100, 30), "east", at(100, 3)));

        world.happens(
                engine,
                new TestActivations("ProxyCompareDistanceRequest")
                        .with("location", points)
                        .with("distance", new RealValue(10))
                        .of("west", "east")
                        .effect());

        assertThat(only("QuantityGreater").proxies()).containsExactly("west");
        assertThat(only("QuantityLess").proxies()).containsExactly("east");
    }

    @Test
    void aBoatWithoutAPointDoesNotKeepTheOthersFromTheirAnswers() {
        Value points = ProxyMaps.toValue(Map.of("east", at(100, 3)));

        world.happens(
                engine,
                new TestActivations("ProxyCompareDistanceRequest")
                        .with("location", points)
                        .with("distance", new RealValue(10))
                        .of("west", "east")
                        .effect());

        assertThat(only("QuantityLess").proxies()).containsExactly("east");
        assertThat(engine.inputs)
                .filteredOn(Input.HandlerFailed.class::isInstance)
                .singleElement()
                .satisfies(failed ->
                        assertThat(((Input.HandlerFailed) failed).reason()).contains("west"));
    }

    @Test
    void aMessageReachesTheOperatorWithItsMarkups() {
        world.happens(
                engine,
                new TestActivations("DisplayMessage")
                        .with("message", new TextValue("All locations visited"))
                        .markup("Keyword", "source", new TextValue("done"))
                        .priority(Priority.HIGH)
                        .of("east")
                        .effect());

        OperatorMessage message = world.operator.messages().messages().get(0);
        assertThat(message.text()).isEqualTo("All locations visited");
        assertThat(message.boats()).containsExactly("east");
        assertThat(message.keyword()).isEqualTo("done");
        assertThat(message.priority()).isEqualTo(Priority.HIGH);
    }

    @Test
    void whatABoatSaysIsWrongReachesTheOperatorAndIsNotReplacedByWhatItSaysNext() {
        InetSocketAddress at = InetSocketAddress.createUnresolved("here", 1);
        for (String text : List.of("east is taken by a pilot", "east refuses the fence")) {
            world.domain.events().onAlarm(new LinkAlarm(LinkAlarm.Kind.SAID_BY_BOAT, "east", at, text));
        }
        world.run(1);

        assertThat(world.operator.messages().messages())
                .filteredOn(message -> message.boats().equals(List.of("east")))
                .filteredOn(message -> message.priority() == Priority.HIGH)
                .extracting(OperatorMessage::text)
                .containsExactlyInAnyOrder("east is taken by a pilot", "east refuses the fence");
    }

    @Test
    void aBoatJoinsOnceWhenItsLinkIsUp() {
        world.cutLinks(true);
        world.run(6);
        world.cutLinks(false);
        world.run(6);

        assertThat(engine.proxies()).containsExactly("west", "east");
        assertThat(engine.received("ProxyCreated"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("west"), List.of("east"));
        assertThat(messages()).anyMatch(text -> text.contains("east is back"));
    }

    @Test
    void lossesOfALinkThatIsLostAgainAndAgainAreCounted() {
        SortedMap<Long, String> told = new TreeMap<>();
        world.operator
                .messages()
                .addListener(entries -> entries.forEach(
                        entry -> told.put(entry.number(), entry.message().text())));
        for (int i = 0; i < 3; i++) {
            world.cutLinks(true);
            world.run(6);
            world.cutLinks(false);
            world.run(6);
        }

        assertThat(told.values())
                .filteredOn(text -> text.contains("link to east"))
                .hasSize(6)
                .contains("The link to east is lost; its commands wait", "The link to east is back")
                .anyMatch(text -> text.matches("The link to east is lost again, 3 times in \\d+ s; its commands wait"))
                .last()
                .asString()
                .matches("The link to east is back; it was lost 3 times in \\d+ s");
    }

    @Test
    void posesAreInputsOnlyWhileATransitionWaitsForThem() {
        world.run(5);
        assertThat(engine.received("ProxyPoseUpdated")).isEmpty();

        engine.awaited.add("ProxyPoseUpdated");
        world.host.post(new Input.TimeReached());
        world.run(2);

        assertThat(engine.received("ProxyPoseUpdated"))
                .extracting(Occurrence::proxies)
                .contains(List.of("west"), List.of("east"));
    }

    @Test
    void aBatteryIsNewsWhenItsClassChanges() {
        int nominal = engine.received("BatteryNominal").size();
        world.hull("east").setBatteryPercent(1);
        world.run(3);
        world.hull("east").setBatteryPercent(0.5);
        world.run(3);

        assertThat(nominal).isEqualTo(2);
        assertThat(engine.received("BatteryCritical")).singleElement().satisfies(news -> {
            assertThat(news.proxies()).containsExactly("east");
            assertThat(news.values()).containsEntry("percent", new RealValue(1));
            assertFitsVocabulary(news);
        });
    }
}
