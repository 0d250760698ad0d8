package org.sami.boat.app.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.hull.position.GpsFix;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Paired;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.OwnPort;

/** Who reaches the boat of a phone, over real links on loopback. */
class PhoneKeysTest {
    @TempDir
    Path folder;

    private final SteadyClock clock = SteadyClock.ofThisMachine();

    @BeforeEach
    void name() throws IOException {
        new PhoneSettings("anna", OwnPort.draw()).write(files());
    }

    private AppFiles files() {
        return new AppFiles(folder);
    }

    private BoatOnPhone begin() throws IOException {
        BoatOnPhone boat = new BoatOnPhone(
                files(),
                PhoneSettings.readOrMake(files(), new Random(1)),
                InetAddress.getLoopbackAddress(),
                new LoopbackBoard.Absent(),
                PictureSource.NONE,
                new PhoneHealth(),
                clock,
                text -> {});
        boat.start();
        Await.until("serves", () -> {
            boat.position().gps(new GpsFix(45.6, 10.6, 2, 0, Double.NaN), clock.getAsLong());
            boat.position().compass(0.5, clock.getAsLong());
            return boat.status().serving() == PhoneStatus.Serving.SERVES;
        });
        return boat;
    }

    private PairedBase base(BoatOnPhone boat) {
        return new PairedBase(boat.status().port(), "anna");
    }

    private static PairingSecret words(BoatOnPhone boat) {
        return boat.keys().words(boat.nowMs()).orElseThrow();
    }

    @Test
    void strangerIsToldOnlyWhoTheBoatIs() throws Exception {
        try (BoatOnPhone boat = begin()) {
            LinkMessage answer = base(boat).hello();

            assertThat(answer).isInstanceOf(Goodbye.class);
            assertThat(((Goodbye) answer).reason()).startsWith("this base is not paired with anna");
        }
    }

    @Test
    void plainLinkIsRefused() throws Exception {
        try (BoatOnPhone boat = begin()) {
            assertThatThrownBy(() -> new LoopbackBase(boat.status().port(), "anna").close())
                    .isInstanceOf(Exception.class);
            assertThat(boat.status().commandedBy()).isEmpty();
        }
    }

    @Test
    void baseThatKnowsTheWordsIsPairedAndBothShowTheSameCheckCode() throws Exception {
        try (BoatOnPhone boat = begin()) {
            PairedBase base = base(boat);
            boat.keys().beginPairing(Role.COMMANDER, boat.nowMs());
            assertThat(boat.keys().secondsLeft(boat.nowMs())).isBetween(1L, PairingResponder.OPEN_MS / 1000);

            assertThat(base.pair(words(boat))).isInstanceOf(Paired.class);

            PhoneKeys.NewBase paired = boat.keys().newBase().orElseThrow();
            assertThat(paired.checkCode()).isEqualTo(base.checkCode(boat.keys().own()));
            assertThat(boat.keys().words(boat.nowMs())).as("used up").isEmpty();
            boat.keys().confirm();
            assertThat(boat.keys().newBase()).isEmpty();
            assertThat(base.hello()).isInstanceOf(Welcome.class);
        }
    }

    @Test
    void otherCheckCodeWithdrawsTheNewBase() throws Exception {
        try (BoatOnPhone boat = begin()) {
            PairedBase base = base(boat);
            boat.keys().beginPairing(Role.COMMANDER, boat.nowMs());
            base.pair(words(boat));

            boat.keys().refuse();

            assertThat(boat.keys().bases()).isEmpty();
            assertThat(boat.keys().newBase()).isEmpty();
            assertThat(((Goodbye) base.hello()).reason()).contains("was withdrawn from anna");
        }
    }

    @Test
    void wordsOfAPairingThatWasEndedCountNoLonger() throws Exception {
        try (BoatOnPhone boat = begin()) {
            boat.keys().beginPairing(Role.COMMANDER, boat.nowMs());
            PairingSecret shown = words(boat);
            boat.keys().endPairing(boat.nowMs());

            assertThat(((Goodbye) base(boat).pair(shown)).reason()).contains("count no longer");
            assertThat(boat.keys().bases()).isEmpty();
            assertThat(boat.keys().secondsLeft(boat.nowMs())).isZero();
        }
    }

    @Test
    void keyAndBasesAreTheSameAfterARestart() throws Exception {
        Fingerprint own;
        PairedBase base;
        try (BoatOnPhone boat = begin()) {
            own = boat.keys().own();
            base = base(boat);
            boat.keys().beginPairing(Role.OBSERVER, boat.nowMs());
            base.pair(words(boat));
        }
        try (BoatOnPhone again = begin()) {
            assertThat(again.keys().own()).isEqualTo(own);
            assertThat(again.keys().bases()).hasSize(1);
            assertThat(again.keys().bases().get(0).role()).isEqualTo(Role.OBSERVER);
            assertThat(((Welcome) base.hello()).role()).isEqualTo(Role.OBSERVER);
        }
        assertThat(Files.getPosixFilePermissions(folder.resolve("keys/identity")))
                .containsExactlyInAnyOrder(PosixFilePermission.OWNER_READ, PosixFilePermission.OWNER_WRITE);
    }

    @Test
    void openLinksTakeABaseWithoutAKeyAndAreOffAtFirst() throws Exception {
        try (BoatOnPhone boat = begin()) {
            assertThat(boat.keys().areLinksOpen()).isFalse();
            boat.keys().setLinksOpen(true);
        }
        try (BoatOnPhone open = begin();
                LoopbackBase base = new LoopbackBase(open.status().port(), "anna")) {
            assertThat(base.welcome().boatId()).isEqualTo("anna");
            assertThat(open.announcement().orElseThrow().entries()).containsEntry("access", "open");
        }
    }

    @Test
    void codeAndAnnouncementNameKeyAndAddress() throws Exception {
        try (BoatOnPhone boat = begin()) {
            assertThat(boat.announcement().orElseThrow().entries()).containsEntry("access", "paired");
            boat.keys().beginPairing(Role.COMMANDER, boat.nowMs());

            PairingCode code =
                    boat.keys().code("192.168.1.7:11411", boat.nowMs()).orElseThrow();

            assertThat(PairingCode.parse(code.toString()).key())
                    .isEqualTo(boat.keys().own());
            assertThat(PairingCode.parse(code.toString()).words()).isEqualTo(words(boat));
            assertThat(boat.announcement().orElseThrow().entries())
                    .containsEntry("access", "pairing")
                    .containsEntry("key", boat.keys().own().shortText())
                    .containsEntry("hull", "differential");
        }
    }

    @Test
    void damagedKeyIsSaidInsteadOfBecomingAnother() throws Exception {
        begin().close();
        Files.write(folder.resolve("keys/identity"), new byte[] {1, 2, 3});

        assertThatThrownBy(this::begin)
                .isInstanceOf(IOException.class)
                .hasMessageContaining("identity holds no key that can be read");
    }
}
