package org.sami.crw.gui.decision;

import java.util.Optional;

/** What keys and buttons do with the decision that is shown. On the event thread. */
interface DecisionSteps {
    /** Gives the answer that is filled in. */
    void answer();

    /** Why the answer that is filled in cannot be given now; empty where it can. */
    Optional<String> whyNot();

    /** Answers with none of what is offered. */
    void refuse();

    /** Why "none of these" is no answer now; empty where it is. */
    Optional<String> whyNotRefuse();

    /** Takes up the pen for the large map; a double click or Enter there leads back to the answer, which is not given by it. */
    void drawOnMap();

    /** Why the shown decision cannot be answered on the large map; empty where it can. */
    Optional<String> whyNotDraw();

    /** Shows another decision, and answers nothing. */
    void browse(int step);

    /** Why no other option can be looked at; empty where one can. */
    Optional<String> whyNotLook();

    /** Looks at another of the options that are compared, so many further on, which chooses none. */
    void look(int step);

    /** Why no decision can be looked at besides the shown one; empty where one can. */
    Optional<String> whyNotBrowse();

    /** Stops the timer after which autonomy would answer. */
    void stopTimer();

    /** Why there is no timer to stop; empty where there is one. */
    Optional<String> whyNotStopTimer();

    /** Chooses an option of the shown decision, from 0; gives no answer. */
    void choose(int option);

    /** Puts the pen down that is out for the shown decision, or else leaves the decision. */
    void escape();

    /** Brings the keyboard's focus to what is to be filled in. */
    void focusDecision();
}
