package org.sami.boat.link.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Role;

/** Keys on a disk: made once, read by their user alone, and never half of them. */
class KeyStoreFolderTest {
    @TempDir
    private Path folder;

    private KeyStoreFolder store() {
        return new KeyStoreFolder(folder.resolve("keys"));
    }

    @Test
    void ownKeyIsMadeOnceAndKept() throws IOException {
        Fingerprint first = store().open().identity().fingerprint();

        assertThat(store().open().identity().fingerprint()).isEqualTo(first);
        assertThat(first.toString()).hasSize(64);
        Path identity = folder.resolve("keys/identity");
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(identity)))
                .isEqualTo("rw-------");
    }

    @Test
    void certificateIsSignedWithTheKeyThatItCarries() throws Exception {
        Identity identity = Identity.generate();

        identity.certificate().verify(identity.certificate().getPublicKey());
        identity.certificate().checkValidity();
        assertThat(identity.certificate().getVersion()).isEqualTo(3);
        assertThat(Identity.generate().fingerprint()).isNotEqualTo(identity.fingerprint());
    }

    @Test
    void keyThatOthersMayReadIsRefusedInWords() throws IOException {
        store().open();
        Path identity = folder.resolve("keys/identity");
        Files.setPosixFilePermissions(identity, PosixFilePermissions.fromString("rw-r-----"));

        assertThatThrownBy(() -> store().open())
                .isInstanceOf(IOException.class)
                .hasMessageContaining("identity holds keys, and others than its user may open it (rw-r-----)");
    }

    @Test
    void damagedKeyAndDamagedPeersAreNamed() throws IOException {
        KeyRing ring = store().open();
        ring.add(new Peer(Identity.generate().fingerprint(), "anna", Role.COMMANDER));
        Path peers = folder.resolve("keys/peers");
        Files.writeString(peers, Files.readString(peers) + "COMMANDER 12 bert\n");
        assertThatThrownBy(() -> store().open()).hasMessageContaining("peers, line 2 is damaged");
        Files.writeString(folder.resolve("keys/identity"), "nothing\n");
        assertThatThrownBy(() -> store().open()).hasMessageContaining("identity holds no key that can be read");
    }

    @Test
    void peersAndWithdrawnKeysAreKept() throws IOException {
        Fingerprint anna = Identity.generate().fingerprint();
        Fingerprint bert = Identity.generate().fingerprint();
        KeyRing ring = store().open();
        ring.add(new Peer(anna, "anna of the lake", Role.COMMANDER));
        ring.add(new Peer(bert, "bert", Role.OBSERVER));
        assertThat(ring.withdraw(List.of(bert))).containsExactly(bert);
        assertThat(ring.withdraw(List.of(bert))).isEmpty();

        KeyRing again = store().open();

        assertThat(again.find(anna)).map(Peer::name).contains("anna of the lake");
        assertThat(again.find(bert)).isEmpty();
        assertThat(again.isWithdrawn(bert)).isTrue();
        again.add(new Peer(bert, "bert", Role.OBSERVER));
        assertThat(store().open().isWithdrawn(bert)).isFalse();
    }
}
