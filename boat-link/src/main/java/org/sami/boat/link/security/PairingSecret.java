package org.sami.boat.link.security;

import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.List;
import java.util.Locale;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * The secret of one pairing: six words that a boat shows and a person enters at the base. Whoever knows it proves that by a code over the two keys of the link, so that
 * nobody in between can pass a proof on: the keys of its links are other ones. Immutable.
 */
public final class PairingSecret {
    /** Number of words. */
    public static final int WORDS = 6;

    private final String words;

    private PairingSecret(String words) {
        this.words = words;
    }

    /** New words by chance. */
    public static PairingSecret random() {
        SecureRandom random = new SecureRandom();
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < WORDS; i++) {
            text.append(i == 0 ? "" : " ").append(PairingWordList.word(random.nextInt(PairingWordList.size())));
        }
        return new PairingSecret(text.toString());
    }

    /**
     * Reads the words as a person types them: in any case, with whatever between them, each as a whole or by its first four letters.
     *
     * @throws IllegalArgumentException naming the word that is none of the list, or how many are missing
     */
    public static PairingSecret parse(String typed) {
        String[] parts = typed.trim().toLowerCase(Locale.ROOT).split("[^a-z]+");
        if (parts.length != WORDS) {
            throw new IllegalArgumentException(
                    "six words are needed, not " + (typed.trim().isEmpty() ? 0 : parts.length));
        }
        StringBuilder text = new StringBuilder();
        for (String part : parts) {
            text.append(text.length() == 0 ? "" : " ").append(PairingWordList.find(part));
        }
        return new PairingSecret(text.toString());
    }

    /** The words of the list that begin so, in order; at most so many. For completion while a person types. */
    public static List<String> beginningWith(String letters, int most) {
        return PairingWordList.beginningWith(letters.toLowerCase(Locale.ROOT), most);
    }

    /** The first four letters of each word, with dots between them; {@link #parse} takes it. */
    public String shortText() {
        StringBuilder text = new StringBuilder();
        for (String word : words.split(" ")) {
            text.append(text.length() == 0 ? "" : ".").append(word, 0, PairingWordList.PREFIX);
        }
        return text.toString();
    }

    /** A base's proof that it knows the words, for this link only; 64 hexadecimal digits. */
    public String proofOfBase(Fingerprint base, Fingerprint boat) {
        return proof("base", base, boat);
    }

    /** The boat's proof that it knows the words. */
    public String proofOfBoat(Fingerprint base, Fingerprint boat) {
        return proof("boat", base, boat);
    }

    private String proof(String by, Fingerprint base, Fingerprint boat) {
        try {
            Mac mac = Mac.getInstance("HmacSHA256");
            mac.init(new SecretKeySpec(words.getBytes(StandardCharsets.UTF_8), "HmacSHA256"));
            mac.update(("SAMI pairing by " + by + "\n").getBytes(StandardCharsets.UTF_8));
            mac.update(base.bytes());
            mac.update(boat.bytes());
            return Hex.of(mac.doFinal());
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java and every Android has it", e);
        }
    }

    /** Whether two proofs are equal; takes the same time wherever they differ. */
    public static boolean isEqual(String proof, String other) {
        return MessageDigest.isEqual(proof.getBytes(StandardCharsets.UTF_8), other.getBytes(StandardCharsets.UTF_8));
    }

    /** Six digits that both sides show after a pairing, equal only if nobody is in between. */
    public static String checkCode(Fingerprint base, Fingerprint boat) {
        byte[] digest = Fingerprint.sha256(("SAMI check " + base + " " + boat).getBytes(StandardCharsets.UTF_8));
        int number =
                ((digest[0] & 0x7f) << 24 | (digest[1] & 0xff) << 16 | (digest[2] & 0xff) << 8 | (digest[3] & 0xff));
        String digits = String.format(Locale.ROOT, "%06d", number % 1_000_000);
        return digits.substring(0, 3) + " " + digits.substring(3);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof PairingSecret && ((PairingSecret) other).words.equals(words);
    }

    @Override
    public int hashCode() {
        return words.hashCode();
    }

    /** The words, with a space between them. */
    @Override
    public String toString() {
        return words;
    }
}
