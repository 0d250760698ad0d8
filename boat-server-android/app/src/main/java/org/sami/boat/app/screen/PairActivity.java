package org.sami.boat.app.screen;

import android.app.Activity;
import android.app.AlertDialog;
import android.os.Bundle;
import android.os.Handler;
import android.os.Looper;
import android.view.LayoutInflater;
import android.view.View;
import android.view.ViewGroup;
import android.view.WindowManager;
import android.widget.Button;
import android.widget.CheckBox;
import android.widget.RadioButton;
import android.widget.TextView;
import java.io.IOException;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.boat.app.R;
import org.sami.boat.app.boat.BoatOnPhone;
import org.sami.boat.app.boat.PhoneKeys;
import org.sami.boat.app.boat.PhoneStatus;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.Peer;

/**
 * Pairs bases with the boat and withdraws them. Words and code are shown while they count; leaving the screen ends that. It cannot be photographed by other apps.
 */
public final class PairActivity extends Activity {
    private static final long PERIOD_MS = 500;
    private static final int SECONDS = 60;

    private final Handler main = new Handler(Looper.getMainLooper());
    private final Runnable looks = this::look;
    private final ServiceLink service = new ServiceLink(this, this::show);
    private boolean waits;
    private String said = "";
    private List<Peer> listed = Collections.emptyList();

    @Override
    protected void onCreate(@Nullable Bundle saved) {
        super.onCreate(saved);
        getWindow().addFlags(WindowManager.LayoutParams.FLAG_SECURE | WindowManager.LayoutParams.FLAG_KEEP_SCREEN_ON);
        setContentView(R.layout.pair);
        click(R.id.begin, this::beginPairing);
        click(R.id.cancel, this::endPairing);
        click(R.id.same, this::confirm);
        click(R.id.different, this::refuse);
        findViewById(R.id.open)
                .setOnClickListener(view -> service.boat().ifPresent(boat -> askOpen(((CheckBox) view).isChecked())));
    }

    private void click(int id, Action action) {
        findViewById(id).setOnClickListener(view -> act(action));
    }

    /** What a press does to the boat. */
    private interface Action {
        void on(BoatOnPhone boat) throws IOException;
    }

    private void act(Action action) {
        service.boat().ifPresent(boat -> {
            said = "";
            try {
                action.on(boat);
            } catch (IOException e) {
                said = String.valueOf(e.getMessage());
            }
            show();
        });
    }

    @Override
    protected void onStart() {
        super.onStart();
        service.open();
        main.post(looks);
    }

    @Override
    protected void onStop() {
        main.removeCallbacks(looks);
        if (!isChangingConfigurations()) {
            service.boat().ifPresent(this::endPairing);
        }
        service.close();
        super.onStop();
    }

    private void look() {
        show();
        main.postDelayed(looks, PERIOD_MS);
    }

    private void beginPairing(BoatOnPhone boat) {
        boolean watches = ((RadioButton) findViewById(R.id.observer)).isChecked();
        boat.keys().beginPairing(watches ? Role.OBSERVER : Role.COMMANDER, boat.nowMs());
    }

    private void endPairing(BoatOnPhone boat) {
        boat.keys().endPairing(boat.nowMs());
        waits = false;
    }

    private void confirm(BoatOnPhone boat) throws IOException {
        Optional<PhoneKeys.NewBase> right = boat.keys().newBase();
        boat.keys().confirm();
        right.ifPresent(base -> said = getString(R.string.pair_done, name(base), may(base.base())));
    }

    private void refuse(BoatOnPhone boat) throws IOException {
        Optional<PhoneKeys.NewBase> wrong = boat.keys().newBase();
        boat.keys().refuse();
        wrong.ifPresent(base -> said = getString(R.string.pair_refused, name(base)));
    }

    private void askOpen(boolean toAll) {
        if (!toAll) {
            act(boat -> setOpen(boat, false));
            return;
        }
        new AlertDialog.Builder(this)
                .setMessage(R.string.open_really)
                .setPositiveButton(R.string.open_yes, (dialog, which) -> act(boat -> setOpen(boat, true)))
                .setNegativeButton(R.string.cancel, (dialog, which) -> dialog.cancel())
                .setOnCancelListener(dialog -> show())
                .show();
    }

    private void setOpen(BoatOnPhone boat, boolean toAll) throws IOException {
        boat.keys().setLinksOpen(toAll);
        service.beginAnew(); // links that stand are ended
    }

    private void askWithdraw(Peer base) {
        new AlertDialog.Builder(this)
                .setMessage(getString(R.string.withdraw_really, base.name()))
                .setPositiveButton(
                        R.string.withdraw,
                        (dialog, which) -> act(boat -> boat.keys().withdraw(base)))
                .setNegativeButton(R.string.cancel, (dialog, which) -> dialog.cancel())
                .show();
    }

    private void show() {
        service.boat().ifPresent(this::show);
    }

    private void show(BoatOnPhone boat) {
        PhoneKeys keys = boat.keys();
        Optional<PairingSecret> words = keys.words(boat.nowMs());
        Optional<PhoneKeys.NewBase> base = keys.newBase();
        if (waits && !words.isPresent() && !base.isPresent()) {
            said = getString(R.string.pair_over);
        }
        waits = words.isPresent();
        visible(R.id.choice, !words.isPresent() && !base.isPresent());
        visible(R.id.secret, words.isPresent());
        visible(R.id.check, base.isPresent());
        text(R.id.state).setText(stateText(boat));
        text(R.id.wrong).setText(said);
        words.ifPresent(secret -> showWords(boat, secret));
        base.ifPresent(one -> text(R.id.check_code).setText(one.checkCode()));
        ((CheckBox) findViewById(R.id.open)).setChecked(keys.areLinksOpen());
        if (!listed.equals(keys.bases()) || ((ViewGroup) findViewById(R.id.bases)).getChildCount() == 0) {
            listed = keys.bases();
            showBases();
        }
    }

    private String stateText(BoatOnPhone boat) {
        Optional<PhoneKeys.NewBase> base = boat.keys().newBase();
        long left = boat.keys().secondsLeft(boat.nowMs());
        if (base.isPresent()) {
            return getString(
                    R.string.pair_check, name(base.get()), may(base.get().base()));
        }
        if (left > 0) {
            String at = address(boat).isEmpty() ? "HOST:" + boat.status().port() : address(boat);
            return getString(R.string.pair_now, at, left / SECONDS, left % SECONDS);
        }
        boolean serves = boat.status().serving() == PhoneStatus.Serving.SERVES;
        return getString(R.string.pair_how) + (serves ? "" : "\n" + getString(R.string.pair_waits));
    }

    private void showWords(BoatOnPhone boat, PairingSecret secret) {
        text(R.id.words).setText(secret.toString());
        CodeView code = findViewById(R.id.code);
        Optional<PairingCode> said = boat.keys().code(address(boat), boat.nowMs());
        said.ifPresent(text -> code.show(text.toString()));
    }

    private static String address(BoatOnPhone boat) {
        String host = PhoneAddress.now();
        return host.isEmpty() ? "" : host + ":" + boat.status().port();
    }

    private void showBases() {
        ViewGroup list = findViewById(R.id.bases);
        list.removeAllViews();
        for (Peer base : listed) {
            View row = LayoutInflater.from(this).inflate(R.layout.base, list, false);
            ((TextView) row.findViewById(R.id.base))
                    .setText(getString(
                            R.string.base,
                            base.name(),
                            may(base),
                            base.fingerprint().shortText()));
            ((Button) row.findViewById(R.id.withdraw)).setOnClickListener(view -> askWithdraw(base));
            list.addView(row);
        }
        if (listed.isEmpty()) {
            TextView none = new TextView(this, null, 0, R.style.Text);
            none.setText(R.string.no_bases);
            list.addView(none);
        }
    }

    private static String name(PhoneKeys.NewBase base) {
        return base.base().name();
    }

    private String may(Peer base) {
        return getString(base.role() == Role.COMMANDER ? R.string.commands : R.string.watches);
    }

    private void visible(int id, boolean shown) {
        findViewById(id).setVisibility(shown ? View.VISIBLE : View.GONE);
    }

    private TextView text(int id) {
        return findViewById(id);
    }
}
