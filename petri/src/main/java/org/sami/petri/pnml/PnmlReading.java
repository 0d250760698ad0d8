package org.sami.petri.pnml;

import java.util.List;
import java.util.Optional;
import org.sami.petri.net.PetriNet;

/**
 * What came of reading a file.
 *
 * @param net the net; empty where there is an error
 * @param findings in the order of the file
 */
public record PnmlReading(Optional<PetriNet> net, List<PnmlFinding> findings) {
    public PnmlReading {
        findings = List.copyOf(findings);
    }

    public boolean hasErrors() {
        return findings.stream().anyMatch(PnmlFinding::isError);
    }
}
