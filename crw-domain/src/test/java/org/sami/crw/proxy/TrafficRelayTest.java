package org.sami.crw.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Motion;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Role;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.proxy.link.ProxyConfig;

/** How often boats are told of which others. Anna is at the origin, Bert 10 m from her, Carl 35 m. */
class TrafficRelayTest {
    private static final LocalFrame FRAME = new LocalFrame(45, 10);

    private final TrafficRelay relay = new TrafficRelay();
    private final List<Told> told = new ArrayList<>();
    private final List<BoatProxy> boats = new ArrayList<>();
    private final List<Double> eastM = List.of(0.0, 10.0, 35.0);
    private long nowMs = 100_000;
    private long sequence;

    /** What a boat was told, and when. */
    private record Told(String to, long atMs, Traffic traffic) {
        boolean isOf(String boat) {
            return traffic.boats().stream().map(NearbyBoat::boatId).anyMatch(boat::equals);
        }
    }

    @BeforeEach
    void link() {
        for (String name : List.of("anna", "bert", "carl")) {
            boats.add(new BoatProxy(name, sink(name), event -> {}, ProxyConfig.DEFAULT));
        }
        for (BoatProxy boat : boats) {
            boat.receive(
                    frame(new Welcome(boat.boatId(), "boot1", Role.COMMANDER, boat.boatId() + ".1", "", true)), nowMs);
            boat.receive(frame(new Progress("", 0, false)), nowMs);
        }
    }

    private FrameSink sink(String name) {
        return new FrameSink() {
            @Override
            public void send(byte[] frame) {
                throw new AssertionError("frames are sent as they are");
            }

            @Override
            public void send(Frame frame) {
                if (frame.message() instanceof Traffic traffic) {
                    told.add(new Told(name, nowMs, traffic));
                }
            }
        };
    }

    private Frame frame(LinkMessage message) {
        return new Frame(sequence++, "", message);
    }

    /** Lets time pass while each of these says all so many milliseconds that it is under way where it is. */
    private void run(double seconds, long everyMs, int... saying) {
        for (int i = 0; i < Math.round(seconds * 10); i++) {
            nowMs += 100;
            for (int index : saying) {
                if (nowMs % everyMs == 0) {
                    double east = eastM.get(index);
                    boats.get(index)
                            .receive(
                                    frame(new Motion(
                                            FRAME.latDeg(east, 0), FRAME.lonDeg(east, 0), 0, 1.5, BoatMode.PATH)),
                                    nowMs);
                }
            }
            boats.forEach(boat -> boat.tick(nowMs));
            relay.tick(boats, nowMs);
        }
    }

    private long timesToAnnaOf(String boat) {
        return told.stream()
                .filter(one -> one.to.equals("anna") && one.isOf(boat))
                .count();
    }

    @Test
    void closeBoatIsToldOfFiveTimesASecondAndOneFartherOffOnce() {
        run(10, 200, 0, 1, 2);

        assertThat(timesToAnnaOf("bert")).isBetween(49L, 51L);
        assertThat(timesToAnnaOf("carl")).isBetween(10L, 12L);
    }

    @Test
    void closeBoatOfWhichNothingNewIsKnownIsToldOfOnceASecond() {
        run(10, 1000, 0, 1, 2);
        told.clear();

        run(10, 1000, 0, 1, 2);

        assertThat(timesToAnnaOf("bert")).isBetween(10L, 20L); // with all others, and when it is news
        assertThat(timesToAnnaOf("carl")).isEqualTo(10);
    }

    @Test
    void boatThatComesCloseIsToldOfAtTheNextLook() {
        run(10, 200, 0, 2);
        told.clear();

        run(0.3, 200, 0, 1, 2);

        assertThat(timesToAnnaOf("bert")).isEqualTo(1);
    }

    @Test
    void notAllBoatsAreToldOfAllInOneMoment() {
        run(2, 200, 0, 1, 2);
        told.clear();

        run(10, 200, 0, 1, 2);

        assertThat(momentsOfASecond("anna")).hasSize(1);
        assertThat(momentsOfASecond("bert")).hasSize(1).isNotEqualTo(momentsOfASecond("anna"));
    }

    /** At which milliseconds of a second a boat is told of Carl, who is close to nobody. */
    private Set<Long> momentsOfASecond(String to) {
        return told.stream()
                .filter(one -> one.to.equals(to) && one.isOf("carl"))
                .map(one -> one.atMs % 1000)
                .collect(Collectors.toSet());
    }
}
