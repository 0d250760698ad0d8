package org.sami.mavlink.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.RadioStatus;
import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class LinkSigningTest {
    private static final SigningKey OURS = key(7);
    private static final SigningKey THEIRS = key(8);
    private static final Instant NOW = Instant.parse("2026-11-27T10:00:00Z");

    private Instant now = NOW;
    private final LinkSigning base = new LinkSigning(OURS, () -> now, LinkSigning.Unsigned.REFUSED);

    private static SigningKey key(int fill) {
        byte[] secret = new byte[SigningKey.BYTES];
        Arrays.fill(secret, (byte) fill);
        return new SigningKey(secret);
    }

    private static byte[] signed(SigningKey key, int link, Instant at) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        LinkSigning sender = new LinkSigning(key, () -> at, LinkSigning.Unsigned.REFUSED);
        MavlinkConnection.create(new ByteArrayInputStream(new byte[0]), bytes)
                .send2(1, 1, MissionCurrent.builder().seq(3).build(), link, sender.nextTime(), key.secret());
        return bytes.toByteArray();
    }

    private static byte[] unsigned(Object payload) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        MavlinkConnection.create(new ByteArrayInputStream(new byte[0]), bytes).send2(1, 1, payload);
        return bytes.toByteArray();
    }

    private static MavlinkPacket packet(byte[] bytes) throws IOException {
        return new MessageReader(new ByteArrayInputStream(bytes), kind -> false).next();
    }

    private Optional<SignatureFault> fault(byte[] bytes) throws IOException {
        return base.fault(packet(bytes));
    }

    @Test
    void messageThatIsSignedNowIsTakenOnce() throws Exception {
        byte[] bytes = signed(OURS, 0, NOW);

        assertThat(fault(bytes)).isEmpty();
        assertThat(fault(bytes)).contains(SignatureFault.REPLAYED);
        assertThat(fault(signed(OURS, 1, NOW))).isEmpty(); // another link of it has times of its own
    }

    @Test
    void messageOfAnotherKeyOrNoneIsRefused() throws Exception {
        assertThat(fault(signed(THEIRS, 0, NOW))).contains(SignatureFault.WRONG);
        assertThat(fault(unsigned(MissionCurrent.builder().seq(3).build()))).contains(SignatureFault.UNSIGNED);
        assertThat(fault(unsigned(RadioStatus.builder().rssi(90).build()))).isEmpty();
    }

    @Test
    void recordingOfYesterdayIsRefusedAlsoByABaseThatHasJustStarted() throws Exception {
        byte[] yesterday = signed(OURS, 0, NOW.minus(Duration.ofDays(1)));
        assertThat(fault(yesterday)).contains(SignatureFault.OLD);

        assertThat(fault(signed(OURS, 0, NOW))).isEmpty();
        assertThat(fault(yesterday)).contains(SignatureFault.OLD);
    }

    @Test
    void timesOnlyGoOnAlsoWhereTheClockOfTheMachineGoesBack() throws Exception {
        long first = base.nextTime();
        now = NOW.minusSeconds(3600);
        assertThat(base.nextTime()).isGreaterThan(first);
        assertThat(fault(signed(OURS, 0, NOW.plusSeconds(5)))).isEmpty();
        assertThat(base.nextTime()).isGreaterThan(first + 4 * 100_000);
    }

    @Test
    void whileKeysAreGivenMessagesWithoutTheKeyAreTakenAndDoNotCountAsSigned() throws Exception {
        LinkSigning giving = new LinkSigning(OURS, () -> now, LinkSigning.Unsigned.TAKEN);

        assertThat(giving.fault(packet(unsigned(MissionCurrent.builder().seq(3).build()))))
                .isEmpty();
        assertThat(giving.fault(packet(signed(THEIRS, 0, NOW)))).isEmpty(); // the key before
        assertThat(giving.isOurs(packet(signed(THEIRS, 0, NOW)))).isFalse();
        assertThat(giving.isOurs(packet(signed(OURS, 0, NOW)))).isTrue();
    }

    @Test
    void vehicleThatHasSignedIsNotTakenWithoutASignatureAnyLonger() throws Exception {
        LinkSigning fleet = new LinkSigning(OURS, () -> now, LinkSigning.Unsigned.TAKEN_UNTIL_SIGNED);
        byte[] unsigned = unsigned(MissionCurrent.builder().seq(3).build());
        assertThat(fleet.fault(packet(unsigned))).isEmpty();
        assertThat(fleet.fault(packet(signed(THEIRS, 0, NOW)))).contains(SignatureFault.WRONG);
        assertThat(fleet.fault(packet(unsigned))).isEmpty();

        assertThat(fleet.fault(packet(signed(OURS, 0, NOW)))).isEmpty();

        assertThat(fleet.fault(packet(unsigned))).contains(SignatureFault.UNSIGNED);
    }

    @Test
    void whoHasSignedWithAFormerKeyGoesOnWithItUntilItSignsWithThePresentOne() throws Exception {
        LinkSigning fleet = new LinkSigning(THEIRS, () -> now, LinkSigning.Unsigned.TAKEN_UNTIL_SIGNED);
        assertThat(fleet.fault(packet(signed(THEIRS, 0, NOW)))).isEmpty();
        fleet.renew(OURS);

        MavlinkPacket former = packet(signed(THEIRS, 0, NOW.plusSeconds(1)));
        assertThat(fleet.fault(former)).isEmpty();
        assertThat(fleet.isOurs(former)).isFalse();
        assertThat(fleet.isSigningWithFormer(1)).isTrue();
        assertThat(fleet.keysTo(1)).containsExactly(THEIRS);
        assertThat(fleet.keysTo(2)).containsExactly(OURS);
        assertThat(fleet.keysTo(LinkSigning.EVERYBODY)).containsExactly(OURS, THEIRS);

        assertThat(fleet.fault(packet(signed(OURS, 0, NOW.plusSeconds(2))))).isEmpty();
        assertThat(fleet.isSigningWithFormer(1)).isFalse();
        assertThat(fleet.keysTo(LinkSigning.EVERYBODY)).containsExactly(OURS);
        assertThat(fleet.fault(packet(signed(THEIRS, 0, NOW.plusSeconds(3))))).contains(SignatureFault.WRONG);
    }

    @Test
    void whoHasNotSignedWithTheFormerKeyIsNotTakenWithItOnceItIsReplaced() throws Exception {
        LinkSigning fleet = new LinkSigning(THEIRS, () -> now, LinkSigning.Unsigned.TAKEN_UNTIL_SIGNED);
        fleet.renew(OURS);

        assertThat(fleet.fault(packet(signed(THEIRS, 0, NOW)))).contains(SignatureFault.WRONG);
    }

    @Test
    void keyIsNotShownAndCannotBeNothing() {
        assertThat(OURS.toString()).matches("signing key [0-9a-f]{16}");
        assertThat(OURS.fingerprint()).isNotEqualTo(THEIRS.fingerprint());
        assertThatThrownBy(() -> new SigningKey(new byte[SigningKey.BYTES]))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new SigningKey(new byte[3])).hasMessageContaining("32 bytes");
    }
}
