package org.sami.crw.session.key;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.PairingText;

/**
 * What a person has typed so far in order to pair a boat, judged while it is typed.
 *
 * @param address {@code HOST:PORT}; may be blank where a QR code says it
 * @param said the boat's words so far, or the text of its QR code
 */
public record PairingDraft(String address, String said) {
    private static final int MOST_OFFERED = 5;

    /** How it stands. */
    public enum State {
        /** Something is still to be typed. */
        UNFINISHED,
        /** Something typed cannot be right. */
        WRONG,
        /** It can be tried. */
        COMPLETE
    }

    /** How it stands, and why in one sentence without its full stop. */
    public record Judgement(State state, String words) {}

    /** Judges it. */
    public Judgement judge() {
        Optional<String> word = PairingCode.isMeant(said) ? Optional.empty() : wrongWord();
        if (word.isPresent()) {
            return new Judgement(State.WRONG, word.get());
        }
        if (said.isBlank()) {
            return new Judgement(
                    State.UNFINISHED, "Type the six words that the boat shows, or paste the text of its QR code");
        }
        try {
            PairingText text = PairingText.parse(said);
            BoatAddress at = text.address(address);
            return new Judgement(
                    State.COMPLETE,
                    text.code()
                            .map(code -> "The QR code is of " + code.boatName() + ", at " + at)
                            .orElse("Six words; the boat is at " + at));
        } catch (IllegalArgumentException unfit) {
            boolean more = !PairingCode.isMeant(said) && typed().length < PairingSecret.WORDS;
            boolean whereOnly = address.isBlank();
            return new Judgement(
                    more || (whereOnly && !PairingCode.isMeant(said)) ? State.UNFINISHED : State.WRONG,
                    more ? typed().length + " of six words are typed" : String.valueOf(unfit.getMessage()));
        }
    }

    private String[] typed() {
        String all = said.strip().toLowerCase(Locale.ROOT);
        return all.isEmpty() ? new String[0] : all.split("[^a-z]+");
    }

    /** The first word with which none of the list begins; a whole one that only begins like one is named too. */
    private Optional<String> wrongWord() {
        String[] words = typed();
        for (int i = 0; i < words.length; i++) {
            boolean last = i == words.length - 1 && Character.isLetter(said.charAt(said.length() - 1));
            String word = words[i];
            List<String> begun = PairingSecret.beginningWith(word, 2);
            boolean known =
                    begun.contains(word) || (begun.size() == 1 && word.length() >= 4) || (last && !begun.isEmpty());
            if (!word.isEmpty() && !known) {
                return Optional.of("'" + word + "' is none of the words that a boat shows");
            }
        }
        if (words.length > PairingSecret.WORDS) {
            return Optional.of("a boat shows six words, not " + words.length);
        }
        return Optional.empty();
    }

    /** Words with which the last one may go on; none where it is whole or a QR code is typed. */
    public List<String> completions() {
        String begun = begun();
        if (begun.isEmpty() || PairingCode.isMeant(said)) {
            return List.of();
        }
        List<String> words = PairingSecret.beginningWith(begun, MOST_OFFERED);
        return words.equals(List.of(begun)) ? List.of() : words;
    }

    /** The text with the last word completed, and a space behind it; as it is where no word begins so. */
    public String completed() {
        List<String> words = completions();
        return words.isEmpty() ? said : said.substring(0, said.length() - begun().length()) + words.get(0) + " ";
    }

    private String begun() {
        int from = said.length();
        while (from > 0 && Character.isLetter(said.charAt(from - 1))) {
            from--;
        }
        return said.substring(from).toLowerCase(Locale.ROOT);
    }
}
