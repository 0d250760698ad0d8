package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Role;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.Welcome;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.spn.value.GeoPoint;

/** Settings on their way to a boat, and what it says of them and of its sensors. */
class TuningTest {
    private final LinkCodec codec = new LinkCodec();
    private final List<LinkMessage> said = new ArrayList<>();
    private final List<Object> heard = new ArrayList<>();
    private BoatProxy proxy;
    private long nowMs = 1000;
    private long sequence;

    @BeforeEach
    void link() {
        Consumer<FleetEvent> listener = event -> {
            if (event instanceof FleetEvent.Measured measured) {
                heard.add(measured.reading());
            } else if (event instanceof FleetEvent.SettingsReported reported) {
                heard.add(reported.settings());
            } else if (event instanceof FleetEvent.SettingRefused refused) {
                heard.add(refused.reason());
            }
        };
        proxy = new BoatProxy("boat1", this::keep, listener, ProxyConfig.DEFAULT);
        boatSays(new Welcome("boat1", "b1", Role.COMMANDER, ""));
        boatSays(new Progress("", 0, false));
    }

    private void keep(byte[] frame) {
        try {
            said.add(codec.decode(frame).message());
        } catch (LinkException e) {
            throw new AssertionError(e);
        }
    }

    private void boatSays(LinkMessage message) {
        proxy.receive(codec.encode(sequence++, message), nowMs);
    }

    private void tickAlive(double seconds) {
        for (int i = 0; i < Math.round(seconds * 10); i++) {
            nowMs += 100;
            proxy.tick(nowMs);
            boatSays(new Heartbeat(nowMs));
        }
    }

    private List<CommandMessage> asked() {
        return said.stream()
                .filter(CommandMessage.class::isInstance)
                .map(CommandMessage.class::cast)
                .toList();
    }

    private String askedId() {
        return asked().get(asked().size() - 1).commandId();
    }

    @Test
    void settingIsAskedForUntilTheBoatAnswers() {
        proxy.settings().setVelocityMultiplier(0.5);
        tickAlive(10);
        int sent = asked().size();
        assertThat(sent).isGreaterThan(1);
        assertThat(asked()).extracting(CommandMessage::commandId).containsOnly(askedId());
        boatSays(new Ack(askedId()));
        tickAlive(10);

        assertThat(asked()).hasSize(sent);
        assertThat(((SetVelocityMultiplier) asked().get(0)).multiplier()).isEqualTo(0.5);
    }

    @Test
    void olderSettingOfAKindIsNotSentAgainAfterANewerOne() {
        proxy.settings().setGains(GainAxis.HEADING, new Gains(1, 0, 0));
        proxy.settings().setGains(GainAxis.SPEED, new Gains(3, 0, 0));
        proxy.settings().setGains(GainAxis.HEADING, new Gains(2, 0, 0));
        said.clear();
        tickAlive(5);

        assertThat(asked())
                .extracting(command -> ((SetGains) command).gains().proportional())
                .contains(2.0, 3.0)
                .doesNotContain(1.0);
    }

    @Test
    void refusalThatWillPassIsNoRefusal() {
        proxy.settings().setLostLinkAction(LostLinkAction.RETURN);
        int before = asked().size();
        boatSays(new Nack(askedId(), NackReason.NOT_COMMANDER, "another commands"));
        tickAlive(5);
        assertThat(asked().size()).isGreaterThan(before);
        assertThat(heard).isEmpty();
        boatSays(new Nack(askedId(), NackReason.MALFORMED, "not one of the words"));
        tickAlive(1);
        int refused = asked().size();
        tickAlive(10);

        assertThat(heard).containsExactly("not one of the words");
        assertThat(asked()).hasSize(refused);
    }

    @Test
    void boatThatNeverAnswersIsTold() {
        proxy.settings().setVelocityMultiplier(2);
        tickAlive(120);

        assertThat(heard).hasSize(1);
        assertThat(heard.get(0).toString()).contains("did not answer");
    }

    @Test
    void listenerLearnsWhatIsInForceAndWhatSensorsMeasure() {
        assertThat(proxy.settings().inForce()).isEmpty();
        Gains heading = new Gains(1, 0, 0);
        boatSays(new SettingsReport(heading, heading, 0.5, LostLinkAction.DRIFT));
        boatSays(new SensorReport("ctd", "temperature", List.of(17.5), "°C", 45, 10, 123));

        BoatTuning tuning = new BoatTuning(heading, heading, 0.5, LostLinkAction.DRIFT);
        assertThat(heard)
                .containsExactly(
                        tuning, new BoatReading("ctd", "temperature", List.of(17.5), "°C", GeoPoint.of(45, 10), 123));
        assertThat(proxy.settings().inForce()).isEqualTo(Optional.of(tuning));
    }
}
