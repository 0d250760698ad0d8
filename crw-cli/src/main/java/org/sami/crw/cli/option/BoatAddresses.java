package org.sami.crw.cli.option;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.tcp.BoatAddress;
import picocli.CommandLine.Parameters;

/** The boats that a command is about, by their addresses. */
public final class BoatAddresses {
    @Parameters(
            paramLabel = "HOST:PORT",
            arity = "1..*",
            description = "Where a boat's server listens; several with spaces or commas between them.")
    private List<String> texts = new ArrayList<>();

    /**
     * Each address once, in the order in which they were given.
     *
     * @throws UsageFault if one is no address; the message names it
     */
    public List<BoatAddress> addresses() {
        Set<BoatAddress> addresses = new LinkedHashSet<>();
        try {
            for (String text : texts) {
                addresses.addAll(BoatAddress.parseAll(text));
            }
        } catch (IllegalArgumentException e) {
            throw new UsageFault(String.valueOf(e.getMessage()));
        }
        return new ArrayList<>(addresses);
    }
}
