package org.sami.crw.cli.key;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.Peer;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw keys withdraw}. */
@Command(
        name = "withdraw",
        mixinStandardHelpOptions = true,
        description = "Withdraws keys: the boats take them no longer once this base has commanded them again.")
final class WithdrawCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private KeyFolderOption keys = new KeyFolderOption();

    @Parameters(
            paramLabel = "KEY",
            arity = "1..*",
            description = "A boat's name, or a fingerprint in full: of a laptop that was lost.")
    private List<String> texts = List.of();

    @Override
    public Integer call() throws IOException {
        KeyRing ring = keys.folder().open();
        List<Fingerprint> chosen = new ArrayList<>();
        for (String text : texts) {
            chosen.add(key(ring, text));
        }
        if (chosen.contains(ring.identity().fingerprint())) {
            throw new UsageFault("a base does not withdraw its own key: do it at another base");
        }
        ring.withdraw(chosen);
        for (Fingerprint one : chosen) {
            spec.commandLine()
                    .getOut()
                    .println(one.shortText() + " is withdrawn here; boats learn it when this base commands them next");
        }
        return ExitCode.OK;
    }

    /** A whole fingerprint, or the name or the beginning of the fingerprint of a peer. */
    private static Fingerprint key(KeyRing ring, String text) {
        if (text.length() == Fingerprint.DIGITS) {
            try {
                return Fingerprint.parse(text);
            } catch (IllegalArgumentException e) {
                throw new UsageFault(String.valueOf(e.getMessage()));
            }
        }
        Optional<Peer> known = ring.peers().stream()
                .filter(peer -> peer.name().equals(text)
                        || peer.fingerprint().toString().startsWith(text))
                .findFirst();
        return known.map(Peer::fingerprint)
                .orElseThrow(() -> new UsageFault("no key here is named '" + text
                        + "'; the key of a lost laptop is written in full, as 'crw keys list' printed it there"));
    }
}
