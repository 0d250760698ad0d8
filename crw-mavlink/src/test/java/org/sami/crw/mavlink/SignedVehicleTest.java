package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.proxy.gateway.GatewayLink;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.mavlink.link.SigningKey;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;

/** A vehicle that takes only what is signed with the key of its fleet. */
@Timeout(900)
class SignedVehicleTest {
    private static final SigningKey OURS = key(7);
    private static final SigningKey THEIRS = key(8);

    @TempDir
    private Path folder;

    private SmallBoat boat;

    private static SigningKey key(int fill) {
        byte[] secret = new byte[SigningKey.BYTES];
        Arrays.fill(secret, (byte) fill);
        return new SigningKey(secret);
    }

    @BeforeEach
    void launch() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 1);
        boat.giveKey(OURS);
    }

    @AfterEach
    void end() throws Exception {
        boat.close();
    }

    @Test
    void isCommandedByABaseThatHasTheKey() {
        try (LinkClient client = new LinkClient(folder, boat.address() + "/5", Optional.of(OURS))) {
            assertThat(client.ask(new HoldPosition("hold"))).isInstanceOf(Ack.class);
            assertThat(boat.isArmed()).isTrue();
        }
    }

    @Test
    void keyThatIsReplacedMeanwhileLosesNoVehicleAndIsUsedOnceTheVehicleHasIt() throws Exception {
        AtomicReference<SigningKey> kept = new AtomicReference<>(OURS);
        try (LinkClient client = new LinkClient(folder, boat.address() + "/5", () -> Optional.of(kept.get()))) {
            assertThat(client.ask(new HoldPosition("first"))).isInstanceOf(Ack.class);

            kept.set(THEIRS);
            client.untilAlarm("The key of the fleet was replaced by " + THEIRS.fingerprint()
                    + "; links to mav5 go on with the one before it");
            assertThat(client.ask(new HoldPosition("with the former one"))).isInstanceOf(Ack.class);

            boat.giveKey(THEIRS);
            assertThat(client.ask(new HoldPosition("with the new one"))).isInstanceOf(Ack.class);
            assertThat(client.reconnect()).isEqualTo(Role.COMMANDER);
        }
    }

    @Test
    void linkThatIsOpenedAfterTheKeyWasReplacedSignsWithTheNewOne() throws Exception {
        AtomicReference<SigningKey> kept = new AtomicReference<>(THEIRS);
        try (MavlinkGateway gateway = new MavlinkGateway(
                SteadyClock.ofThisMachine(), new VehicleFiles(folder), () -> Optional.of(kept.get()))) {
            kept.set(OURS);
            Ending ending = new Ending();
            gateway.connect(BoatAddress.parse(boat.address() + "/5").toSocketAddress(), ending);

            assertThat(ending.why.get(60, TimeUnit.SECONDS)).isEqualTo("opened");
        }
    }

    @Test
    void sessionThatBeganWithoutAKeyIsToldThatItSignsNothing() throws Exception {
        try (SmallBoat unsigned = new SmallBoat(6, 45.7, 10.72, 1)) {
            AtomicReference<Optional<SigningKey>> kept = new AtomicReference<>(Optional.empty());
            try (LinkClient client = new LinkClient(folder, unsigned.address() + "/6", kept::get)) {
                kept.set(Optional.of(OURS));

                client.untilAlarm(
                        "was made after this session began, which therefore signs nothing that it sends to mav6");
            }
        }
    }

    @Test
    void baseWithAnotherKeyIsToldWhyNothingIsHeard() throws Exception {
        try (MavlinkGateway gateway =
                new MavlinkGateway(SteadyClock.ofThisMachine(), new VehicleFiles(folder), Optional.of(THEIRS))) {
            Ending ending = new Ending();
            gateway.connect(BoatAddress.parse(boat.address() + "/5").toSocketAddress(), ending);

            assertThat(ending.why.get(60, TimeUnit.SECONDS))
                    .startsWith("no vehicle 5 is heard there; refused ")
                    .contains("messages with a wrong signature");
        }
        assertThat(boat.orderedModes()).isEqualTo(List.of());
    }

    @Test
    void baseWithoutAKeyIsToldThatTheVehicleSigns() throws Exception {
        try (MavlinkGateway gateway =
                new MavlinkGateway(SteadyClock.ofThisMachine(), new VehicleFiles(folder), Optional.empty())) {
            Ending ending = new Ending();
            gateway.connect(BoatAddress.parse(boat.address() + "/5").toSocketAddress(), ending);

            assertThat(ending.why.get(60, TimeUnit.SECONDS))
                    .contains("vehicle 5 signs what it sends, and this base has no key");
        }
    }

    private static final class Ending implements GatewayLink.Listener {
        private final CompletableFuture<String> why = new CompletableFuture<>();

        @Override
        public void opened() {
            why.complete("opened");
        }

        @Override
        public void arrived(byte[] frame) {
            // nothing is asked for
        }

        @Override
        public void said(Priority priority, String text) {
            // none is expected
        }

        @Override
        public void closed(String reason) {
            why.complete(reason);
        }

        @Override
        public void found(InetSocketAddress vehicle) {
            // one is asked for
        }
    }
}
