package org.sami.boat.link.security;

import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.PrivateKey;
import java.security.SecureRandom;
import java.security.cert.X509Certificate;
import java.security.spec.ECGenParameterSpec;
import java.util.Objects;

/**
 * The key of one boat or base: a private key, and the certificate that carries its public key. The private key may be one that never leaves a phone's key
 * store. Immutable.
 */
public final class Identity {
    private final PrivateKey key;
    private final X509Certificate certificate;

    /** An identity of a key and its certificate, from wherever the platform keeps them. */
    public Identity(PrivateKey key, X509Certificate certificate) {
        this.key = Objects.requireNonNull(key, "key");
        this.certificate = Objects.requireNonNull(certificate, "certificate");
    }

    /** A new key on the curve P-256. */
    public static Identity generate() {
        try {
            KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
            generator.initialize(new ECGenParameterSpec("secp256r1"), new SecureRandom());
            KeyPair keys = generator.generateKeyPair();
            return new Identity(keys.getPrivate(), SelfSignedCertificate.of(keys));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java and every Android has keys on P-256", e);
        }
    }

    /** Names the key. */
    public Fingerprint fingerprint() {
        return Fingerprint.of(certificate.getPublicKey());
    }

    /** The private key. */
    public PrivateKey key() {
        return key;
    }

    /** The certificate. */
    public X509Certificate certificate() {
        return certificate;
    }
}
