package org.sami.crw.cli.key;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.concurrent.Callable;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.Peer;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.mavlink.link.SigningKey;
import org.sami.session.server.ServerAddress;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code crw keys list}. */
@Command(
        name = "list",
        mixinStandardHelpOptions = true,
        description = "Lists the key of this base and the certificate with which it serves sessions, the boats that are"
                + " paired with it, and the keys that were withdrawn.")
final class KeyListCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private KeyFolderOption keys = new KeyFolderOption();

    @Override
    public Integer call() throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        BaseKeys.Listing list = keys.keys().list();
        out.println(list.own() + "  this base");
        out.println(
                ServerAddress.print(keys.keys().open().identity()) + "  its certificate, where it serves a session");
        for (BaseKeys.Known known : list.boats()) {
            Peer boat = known.boat();
            out.println(boat.fingerprint() + "  boat " + boat.name());
        }
        for (Fingerprint withdrawn : list.withdrawn()) {
            out.println(withdrawn + "  withdrawn");
        }
        keys.keys()
                .fleetKey()
                .ifPresent(secret ->
                        out.println(new SigningKey(secret).fingerprint() + "  fleet of vehicles that speak MAVLink"));
        return ExitCode.OK;
    }
}
