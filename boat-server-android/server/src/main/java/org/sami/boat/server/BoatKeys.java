package org.sami.boat.server;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.Pair;
import org.sami.boat.link.Paired;
import org.sami.boat.link.Role;
import org.sami.boat.link.WithdrawKeys;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.Peer;

/** What clients may do by their keys, on a boat that speaks with protection. Safe for use by several threads. */
public final class BoatKeys {
    private final KeyRing ring;
    private final PairingResponder responder;

    /** The keys of a boat, and where bases are paired with it. */
    public BoatKeys(KeyRing ring, PairingResponder responder) {
        this.ring = ring;
        this.responder = responder;
    }

    /** The most that a key is granted; empty for a stranger. */
    Optional<Role> roleOf(Fingerprint key) {
        return ring.find(key).map(Peer::role);
    }

    /** Why a stranger is a stranger. */
    String whyStranger(Fingerprint key, String boatId) {
        return ring.isWithdrawn(key)
                ? "this base's key was withdrawn from " + boatId
                : "this base is not paired with " + boatId + ": crw keys pair HOST:PORT";
    }

    /** Pairs a base, or throws the reason. */
    Paired pair(Fingerprint key, Pair request, String boatId, long nowMs) throws IOException {
        String proof = responder.pair(key, request.clientId(), request.proof(), request.role(), nowMs);
        return new Paired(boatId, proof, roleOf(key).orElse(Role.OBSERVER));
    }

    /** Withdraws keys but that of who asks. */
    void withdraw(WithdrawKeys command, Fingerprint by) throws IOException {
        List<Fingerprint> keys = new ArrayList<>();
        for (String key : command.keys()) {
            Fingerprint one = Fingerprint.parse(key);
            if (!one.equals(by)) {
                keys.add(one);
            }
        }
        ring.withdraw(keys);
    }
}
