package org.sami.dreamm.context;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.model.Plan;

class DomainSourceTest {
    @Test
    void boatsDomainIsTakenWhereNobodyNamesOne() {
        assertThat(DomainSource.of(Optional.empty())).isEqualTo(DomainSource.SHIPPED);
    }

    @Test
    void domainThatShipsIsTakenByItsName() {
        DomainSource uav = DomainSource.of(Optional.of(Path.of("uav")));

        assertThat(uav.library().orThrow().plans()).extracting(Plan::id).contains("search");
        assertThat(uav.hasLegacyTable()).isFalse();
        assertThat(uav.title()).isEqualTo("the domain /org/sami/domain/uav");
    }

    @Test
    void anythingElseIsAFolder(@TempDir Path folder) {
        assertThat(DomainSource.of(Optional.of(folder)).folder()).contains(folder);
        assertThat(DomainSource.of(Optional.of(Path.of("rovers"))).library().hasErrors())
                .isTrue();
    }
}
