package org.sami.boat.link.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Role;

/** The keys of a boat or base, and which of them count. */
class KeyRingTest {
    private final KeyRing ring = KeyRing.inMemory();

    @Test
    void peersKeyIsWithdrawnHoweverManyWere() throws IOException {
        Fingerprint lost = Identity.generate().fingerprint();
        ring.add(new Peer(lost, "lost laptop", Role.COMMANDER));
        List<Fingerprint> others = new ArrayList<>();
        for (int i = 0; i < 1000; i++) {
            others.add(Fingerprint.parse(String.format("%064x", i)));
        }
        ring.withdraw(others);

        assertThat(ring.withdraw(List.of(lost))).containsExactly(lost);

        assertThat(ring.find(lost)).isEmpty();
    }

    @Test
    void keyThatIsPairedAgainCounts() throws IOException {
        Peer laptop = new Peer(Identity.generate().fingerprint(), "laptop", Role.COMMANDER);
        ring.add(laptop);
        ring.withdraw(List.of(laptop.fingerprint()));

        ring.add(laptop);

        assertThat(ring.find(laptop.fingerprint())).contains(laptop);
        assertThat(ring.isWithdrawn(laptop.fingerprint())).isFalse();
    }
}
