package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;

class ShippedFilesTest {
    private static final String CRW = "/org/sami/domain/crw";

    @Test
    void boatsDomainIsReadWithoutAnyFinding() {
        Reading<DomainLibrary> reading = DomainLibrary.fromClassPath(CRW);

        assertThat(reading.findings()).isEmpty();
        assertThat(reading.orThrow().plans()).extracting(Plan::id).containsExactly("clv", "station-keep");
        assertThat(reading.orThrow().vocabulary().markups()).hasSize(16);
    }
}
