package org.sami.crw.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.spn.json.DomainLibrary;

class SessionSetupTest {
    @Test
    void boatsThatSayNothingAreTakenToBeAsInTheField() {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

        SessionSetup setup = SessionSetup.of(library.vocabulary(), library.combined());

        assertThat(setup.services().error()).isEqualTo(CrossTrackError.FIELD);
    }
}
