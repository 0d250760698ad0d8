package org.sami.crw.proxy.near;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.boat.link.BoatAnnouncement.Access;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.Peer;
import org.sami.crw.proxy.near.NearBoat.State;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.proxy.tcp.BoatAddress;

/** Which boats a base can connect to, by its keys and by what they announce. */
class NearBoatTest {
    private static final BoatAddress ON_THE_WATER = new BoatAddress("10.0.0.11", 11411);

    @TempDir
    private Path folder;

    private KeyRing keys;
    private Identity boat;

    @BeforeEach
    void keys() throws IOException {
        keys = new KeyStoreFolder(folder).open();
        boat = Identity.generate();
    }

    @Test
    void pairedBoatCanBeConnectedUntilItsKeyIsWithdrawn() throws IOException {
        assertThat(stateOf(Access.PAIRED)).isEqualTo(State.NOT_PAIRED);
        assertThat(stateOf(Access.PAIRING)).isEqualTo(State.PAIRING);

        keys.add(new Peer(boat.fingerprint(), "anna", Role.COMMANDER));
        assertThat(stateOf(Access.PAIRED)).isEqualTo(State.PAIRED);
        assertThat(stateOf(Access.PAIRED).canConnect()).isTrue();

        keys.withdraw(List.of(boat.fingerprint()));
        assertThat(stateOf(Access.PAIRED)).isEqualTo(State.WITHDRAWN);
    }

    @Test
    void openBoatOnAnotherMachineIsOnlyForBasesThatTakePlainLinks() throws IOException {
        assertThat(stateOf(Access.OPEN)).isEqualTo(State.PLAIN_REFUSED);
        FoundBoat open = found(Access.OPEN, 2);
        BaseProtection plain = new BaseProtection(Optional.empty(), true);
        assertThat(NearBoat.of(List.of(open), plain, Set.of()).get(0).state()).isEqualTo(State.OPEN);
    }

    @Test
    void boatsOfAnotherVersionAndConnectedOnesAreToldApart() throws IOException {
        NearBoat other =
                NearBoat.of(List.of(found(Access.PAIRED, 3)), base(), Set.of()).get(0);
        assertThat(other.state()).isEqualTo(State.OTHER_VERSION);
        assertThat(other.stateWords()).isEqualTo("another version (link 3)");
        assertThat(NearBoat.of(List.of(found(Access.PAIRED, 2)), base(), Set.of(ON_THE_WATER))
                        .get(0)
                        .state())
                .isEqualTo(State.CONNECTED);
    }

    private State stateOf(Access access) throws IOException {
        return NearBoat.of(List.of(found(access, 2)), base(), Set.of()).get(0).state();
    }

    private BaseProtection base() {
        return new BaseProtection(Optional.of(folder), false);
    }

    private FoundBoat found(Access access, int link) {
        String key = access == Access.OPEN ? "" : boat.fingerprint().shortText();
        return new FoundBoat(
                new BoatAnnouncement("anna", "anna", key, access, link, OptionalInt.empty(), "rudder"), ON_THE_WATER);
    }
}
