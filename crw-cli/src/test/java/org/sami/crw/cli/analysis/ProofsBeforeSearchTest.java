package org.sami.crw.cli.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.model.ExampleNets;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.QueryFaultException;
import org.sami.petri.query.QueryParser;

class ProofsBeforeSearchTest {
    private static final String QUERY = "bound buffer";

    private static Optional<NetAnalysis> answer(long bytes) throws QueryFaultException {
        PetriNet net = ExampleNets.producerConsumer(0);
        SearchBudget budget = new SearchBudget(1000, bytes, Duration.ofDays(1));
        return new ProofsBeforeSearch(net, budget, GraphWatch.NONE, () -> false)
                .answer(QUERY, QueryParser.query(net, QUERY));
    }

    /** The set has 4 markings of 5 places, of 150 bytes each. */
    @Test
    void coverabilitySetHasAQuarterOfTheMemory() throws QueryFaultException {
        assertThat(answer(4 * 1500)).isPresent();
        assertThat(answer(1500)).isEmpty();
    }
}
