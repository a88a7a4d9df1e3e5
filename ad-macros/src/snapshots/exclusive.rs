fn deposit(account: &mut Account, amounts: &[f64], i: usize) -> f64 {
    account.total += amounts[i];
    fee(&mut account.fees[i], amounts);
    account.close(amounts[0]);
    account.total - amounts[i]
}
