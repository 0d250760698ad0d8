package org.sami.crw.cli.key;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.Peer;
import org.sami.crw.cli.output.ExitCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code crw keys list}. */
@Command(
        name = "list",
        mixinStandardHelpOptions = true,
        description =
                "Lists the key of this base, the boats that are paired with it, and the keys that were withdrawn.")
final class KeyListCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private KeyFolderOption keys = new KeyFolderOption();

    @Override
    public Integer call() throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        KeyRing ring = keys.folder().open();
        out.println(ring.identity().fingerprint() + "  this base");
        for (Peer peer : ring.peers()) {
            out.println(peer.fingerprint() + "  boat " + peer.name());
        }
        for (Fingerprint withdrawn : ring.withdrawn()) {
            out.println(withdrawn + "  withdrawn");
        }
        return ExitCode.OK;
    }
}
